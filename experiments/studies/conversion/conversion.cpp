// SPDX-License-Identifier: MIT
#include "experiments/studies/conversion/conversion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/evaluate/kernel.hpp"
#include "experiments/judge/method_choice.hpp"
#include "experiments/judge/study_inputs.hpp"
#include "experiments/metric/all_finite.hpp"
#include "experiments/number/number.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/statistics.hpp"
#include "reference/exact_conversion.hpp"

namespace bezierbench::studies {
namespace {

struct Threshold {
  std::string_view column;
  double distance;
};
constexpr std::array thresholds{Threshold{"within_1e-5", 1e-5}, Threshold{"within_1e-3", 1e-3},
                                Threshold{"within_0.1", 0.1}};

/// One conversion or a chain of them.
struct Chain {
  std::string id;
  std::vector<const ConversionKernel<double>*> steps;
  [[nodiscard]] bool supports(int degree) const {
    return std::ranges::all_of(
        steps, [degree](const ConversionKernel<double>* step) { return step->info->supports<double>(degree); });
  }
};

/// The conversion or chain in entry `k` of the study's methods. Refuses a conversion that does not start from the form
/// before it.
Chain chain_of(const suite::Study& study, std::size_t k, int dimension) {
  const std::string& id = study.methods[k];
  Chain chain{id, {}};
  Form form = study.curve;
  for (std::size_t begin = 0; begin <= id.size();) {
    const auto end = std::min(id.find('+', begin), id.size());
    const auto part = id.substr(begin, end - begin);
    const auto* step = find_conversion<double>(part, form, dimension);
    if (step == nullptr)
      suite::refuse(
          study, {"methods", k, "curve",
                  fmt::format("conversion \"{}\" does not start from {} form; see `list methods`", part, name(form))});
    chain.steps.push_back(step);
    form = form == Form::bernstein ? Form::power : Form::bernstein;
    begin = end + 1;
  }
  return chain;
}

/// The chains of the study's methods; every conversion from the study's form where the study names none.
std::vector<Chain> chains_of(const suite::Study& study, int dimension) {
  std::vector<Chain> chains;
  for (std::size_t k = 0; k < study.methods.size(); ++k) chains.push_back(chain_of(study, k, dimension));
  if (!study.methods.empty()) return chains;
  for (const auto& step : conversion_kernels<double>(dimension))
    if (step.info->form == study.curve) chains.push_back({std::string(step.info->id), {&step}});
  return chains;
}

/// The largest distance of corresponding coefficients; infinite if one is not finite.
double largest_distance(std::span<const double> computed, const std::vector<reference::ExactPoint>& truth,
                        std::size_t d) {
  if (!metric::all_finite(computed)) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    largest = std::max(largest, reference::Distance(truth[i]).to(computed.subspan(i * d, d)));
  return largest;
}

double largest_distance(std::span<const double> computed, std::span<const double> truth, std::size_t d) {
  if (!metric::all_finite(computed)) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < truth.size(); i += d)
    largest = std::max(largest, reference::Distance(truth.subspan(i, d)).to(computed.subspan(i, d)));
  return largest;
}

/// A row of the table is about one cell and one chain.
struct Row {
  sample::Cell cell;
  Chain chain;
};

/// Tallies of one row. Every block adds trials of one replicate.
struct RowTally {
  metric::Tally error;
  std::uint64_t non_finite = 0;
  std::map<std::size_t, std::array<std::int64_t, thresholds.size()>> within;  ///< per replicate

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.non_finite, self.within);
  }
  void merge(const RowTally& other) {
    error.merge(other.error);
    non_finite += other.non_finite;
    within.insert(other.within.begin(), other.within.end());
  }
};

class ConversionJob final : public run::JobOf<RowTally> {
 public:
  ConversionJob(const suite::Study& study, std::uint64_t seed) : study_(study), seed_(seed) {
    judge::check_inputs(study_);
    for (const auto& cell : sample::cells(study_))
      for (auto& chain : chains_of(study_, cell.dimension)) rows_.push_back({cell, std::move(chain)});
  }

  [[nodiscard]] std::size_t parts() const override { return rows_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return static_cast<std::size_t>(study_.replicates); }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double n = rows_[part].cell.degree + 1.0;
    return static_cast<double>(study_.trials) * n * n * 200;
  }
  [[nodiscard]] run::Extent extent() const override {
    return {sample::cells(study_).size(), rows_.size(), blocks() * static_cast<std::uint64_t>(study_.trials)};
  }
  void write(tables::Tables& tables) const override;
  [[nodiscard]] std::vector<tables::Series> series() const override;

 protected:
  [[nodiscard]] RowTally work(std::size_t block) const override;

 private:
  static double error_of(const Chain& chain, const CurveView<double>& curve);

  suite::Study study_;
  std::uint64_t seed_;
  std::vector<Row> rows_;
};

double ConversionJob::error_of(const Chain& chain, const CurveView<double>& curve) {
  std::vector<double> current(curve.coefficients.begin(), curve.coefficients.end());
  std::vector<double> next(current.size());
  std::vector<double> last_in_original_form;
  CurveView<double> view = curve;
  for (const auto* step : chain.steps) {
    view.coefficients = current;
    step->convert(view, next.data());
    std::swap(current, next);
    view.form = view.form == Form::bernstein ? Form::power : Form::bernstein;
    if (view.form == curve.form) last_in_original_form = current;
  }
  const auto d = static_cast<std::size_t>(curve.dimension);
  if (chain.steps.size() == 1) return largest_distance(current, reference::converted(curve), d);
  return largest_distance(last_in_original_form, curve.coefficients, d);
}

RowTally ConversionJob::work(std::size_t block) const {
  const auto replicate = block % blocks_per_part();
  const Row& row = rows_[part_of(block)];
  RowTally tally;
  auto& within = tally.within[replicate];
  if (!row.chain.supports(row.cell.degree)) return tally;
  const sample::Sampler sampler(seed_, study_.id, row.cell);
  sample::Trial trial;
  for (std::int64_t k = 0; k < study_.trials && !run::interrupted(); ++k) {
    sampler.draw(static_cast<std::uint64_t>(static_cast<std::int64_t>(replicate) * study_.trials + k), trial);
    const double error = error_of(row.chain, {study_.curve, row.cell.dimension, row.cell.degree, trial.coefficients});
    if (!std::isfinite(error)) {
      ++tally.non_finite;
      continue;
    }
    tally.error.add(error);
    for (std::size_t i = 0; i < thresholds.size(); ++i) within[i] += error <= thresholds[i].distance ? 1 : 0;
  }
  return tally;
}

void ConversionJob::write(tables::Tables& tables) const {
  (void)tables.table("conversion.csv");
  for (std::size_t part = 0; part < rows_.size(); ++part) {
    const auto& [cell, chain] = rows_[part];
    const RowTally& tally = state(part);
    tables::Row row("conversion.csv");
    row.set("study", study_.id)
        .set("conversion", chain.id)
        .set("degree", cell.degree)
        .set("coordinate_range", cell.coordinate_range)
        .set("generator", cell.generator)
        .set("trials", study_.trials * study_.replicates)
        .set("curve", suite::name(study_.curve))
        .set("dimension", cell.dimension);
    row.set("mean_error", tables::field(tally.error, tables::mean))
        .set("max_error", tables::field(tally.error, tables::largest));
    const bool supported = chain.supports(cell.degree);
    row.set("status", supported ? "ok" : "degree_unsupported");
    for (std::size_t i = 0; i < thresholds.size() && supported; ++i) {
      std::int64_t sum = 0;
      for (const auto& [replicate, within] : tally.within) sum += within[i];
      row.set(thresholds[i].column, sum);
    }
    if (supported) row.set("non_finite", tally.non_finite);
    tables.add(row);
  }
}

std::vector<tables::Series> ConversionJob::series() const {
  const auto [lowest, highest] = std::ranges::minmax(study_.degree);
  const auto degrees = lowest == highest ? std::to_string(lowest) : fmt::format("{}..{}", lowest, highest);
  std::vector<tables::Series> all;
  const auto series_of = [&](const Row& row, std::string_view threshold) -> tables::Series& {
    const auto statistic = fmt::format("count_{}", threshold);
    for (auto& one : all)
      if (one.method == row.chain.id && one.generator == row.cell.generator && one.statistic == statistic &&
          one.coordinate_range == row.cell.coordinate_range)
        return one;
    tables::Series one{
        .study = study_.id,
        .curve = std::string(suite::name(study_.curve)),
        .method = row.chain.id,
        .statistic = statistic,
        .degree = degrees,
        .coordinate_range = row.cell.coordinate_range,
        .t_interval = std::nullopt,
        .generator = row.cell.generator,
        .baseline = "exact",  // a round trip is compared with the curve that it started from, known exactly
        .mode = "",
        .values = std::vector<double>(static_cast<std::size_t>(study_.replicates))};
    return all.emplace_back(std::move(one));
  };
  for (std::size_t part = 0; part < rows_.size(); ++part)
    for (std::size_t i = 0; i < thresholds.size(); ++i) {
      auto& values = series_of(rows_[part], thresholds[i].column).values;
      for (const auto& [replicate, within] : state(part).within) values.at(replicate) += static_cast<double>(within[i]);
    }
  return all;
}

}  // namespace

std::unique_ptr<run::Job> conversion_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<ConversionJob>(study, context.seed);
}

}  // namespace bezierbench::studies
