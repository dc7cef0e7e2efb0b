// SPDX-License-Identifier: MIT
// Studies of kind `conversion`. Random curves go through one conversion, judged against the exact one, or through a
// chain such as `factorial+forward_substitution+factorial`, judged by the distance of the last curve in the original
// form from the original curve. The error of a trial is the largest distance between corresponding coefficients.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/run/blocks/trial_blocks.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/validate.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/error/norm.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/number.hpp"

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
  Form form = study.form;
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
    if (step.info->form == study.form) chains.push_back({std::string(step.info->id), {&step}});
  return chains;
}

/// The largest distance of corresponding coefficients; infinite if one is not finite.
double largest_distance(std::span<const double> computed, const std::vector<reference::ExactPoint>& truth,
                        std::size_t d) {
  if (!reference::all_finite(computed)) return std::numeric_limits<double>::infinity();
  double distance = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    distance = std::max(distance, reference::Distance(truth[i]).to(computed.subspan(i * d, d)));
  return distance;
}

double largest_distance(std::span<const double> computed, std::span<const double> truth, std::size_t d) {
  if (!reference::all_finite(computed)) return std::numeric_limits<double>::infinity();
  double distance = 0;
  for (std::size_t i = 0; i < truth.size(); i += d)
    distance = std::max(distance, reference::Distance(truth.subspan(i, d)).to(computed.subspan(i, d)));
  return distance;
}

/// The errors of one chain in one cell.
struct ChainErrors {
  metric::Tally error;
  std::uint64_t non_finite = 0;
  std::map<std::int64_t, std::array<std::uint64_t, thresholds.size()>> within;  ///< trials of each replicate

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.non_finite, self.within);
  }
};

/// A cell is a part.
class ConversionJob final : public run::JobOf<metric::Rows<ChainErrors>> {
 public:
  ConversionJob(const suite::Study& study, std::uint64_t seed)
      : study_(study), seed_(seed), blocks_(study.trials, study.replicates, block_trials) {
    judge::check_inputs(study_);
    for (const auto& cell : sample::cells(study_)) parts_.push_back({cell, chains_of(study_, cell.dimension)});
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return blocks_.count(); }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double n = parts_[part].cell.degree + 1.0;
    return static_cast<double>(blocks_.full()) * n * n * 200 * static_cast<double>(parts_[part].chains.size());
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (const Part& part : parts_)
      sum += {1, part.chains.size(), part.chains.size() * static_cast<std::uint64_t>(trials())};
    return sum;
  }
  void write(tables::Tables& tables) const override;
  [[nodiscard]] std::vector<tables::Series> series() const override;

 protected:
  [[nodiscard]] metric::Rows<ChainErrors> work(std::size_t block) const override;

 private:
  struct Part {
    sample::Cell cell;
    std::vector<Chain> chains;
  };

  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }
  static double error_of(const Chain& chain, const CurveView<double>& curve);
  /// Visits all rows: by cell, then by chain in the order of the study.
  template <class Visit>
  void each_row(const Visit& visit) const {
    for (std::size_t part = 0; part < parts_.size(); ++part)
      for (std::size_t c = 0; c < parts_[part].chains.size(); ++c)
        visit(parts_[part].cell, parts_[part].chains[c], state(part).rows.at(c));
  }

  static constexpr std::int64_t block_trials = 1024;

  suite::Study study_;
  std::uint64_t seed_;
  run::TrialBlocks blocks_;
  std::vector<Part> parts_;
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

void add_error(double error, std::int64_t replicate, ChainErrors& errors) {
  if (!std::isfinite(error)) {
    ++errors.non_finite;
    return;
  }
  errors.error.add(error);
  auto& within = errors.within[replicate];
  for (std::size_t i = 0; i < thresholds.size(); ++i) within[i] += error <= thresholds[i].distance ? 1 : 0;
}

metric::Rows<ChainErrors> ConversionJob::work(std::size_t block) const {
  const auto trials = blocks_[block % blocks_per_part()];
  const Part& part = parts_[part_of(block)];
  const auto& cell = part.cell;  // no structured binding: Clang 14 captures none
  const auto& chains = part.chains;
  metric::Rows<ChainErrors> tally{std::vector<ChainErrors>(chains.size())};
  const sample::Sampler sampler(seed_, study_.id, cell);
  sample::Trial trial;
  run::each_trial(trials, [&](std::int64_t k) {
    sampler.draw(static_cast<std::uint64_t>(trials.replicate * study_.trials + k), trial);
    const CurveView<double> curve{study_.form, cell.dimension, cell.degree, trial.coefficients};
    for (std::size_t c = 0; c < chains.size(); ++c)
      if (chains[c].supports(cell.degree)) add_error(error_of(chains[c], curve), trials.replicate, tally.rows[c]);
  });
  return tally;
}

void ConversionJob::write(tables::Tables& tables) const {
  (void)tables.table("conversion.csv");
  each_row([&](const sample::Cell& cell, const Chain& chain, const ChainErrors& errors) {
    tables::Row row("conversion.csv");
    const auto drawn = tables::drawn_fields(cell);
    row.set("study", study_.id)
        .set("conversion", chain.id)
        .set("degree", cell.degree)
        .set("coordinate_range", drawn[0])
        .set("generator", drawn[3])
        .set("curves", drawn[4])
        .set("trials", trials())
        .set("form", name(study_.form))
        .set("dimension", cell.dimension)
        .set("mean_error", tables::field(errors.error, tables::mean))
        .set("max_error", tables::field(errors.error, tables::largest));
    const bool supported = chain.supports(cell.degree);
    row.set("status", supported ? "ok" : "degree_unsupported");
    for (std::size_t i = 0; i < thresholds.size() && supported; ++i) {
      std::uint64_t sum = 0;
      for (const auto& [replicate, within] : errors.within) sum += within[i];
      row.set(thresholds[i].column, sum);
    }
    if (supported) row.set("non_finite", errors.non_finite);
    tables.add(row);
  });
}

std::vector<tables::Series> ConversionJob::series() const {
  const auto [lowest, highest] = std::ranges::minmax(study_.degree);
  const auto degrees = lowest == highest ? std::to_string(lowest) : fmt::format("{}..{}", lowest, highest);
  std::vector<tables::Series> all;
  const auto series_of = [&](const sample::Cell& cell, const Chain& chain,
                             std::string_view threshold) -> tables::Series& {
    const auto statistic = fmt::format("count_{}", threshold);
    for (auto& one : all)
      if (one.method == chain.id && one.generator == cell.generator && one.statistic == statistic &&
          one.coordinate_range == cell.coordinate_range)
        return one;
    tables::Series one{
        .study = study_.id,
        .form = std::string(name(study_.form)),
        .method = chain.id,
        .statistic = statistic,
        .degree = degrees,
        .coordinate_range = cell.coordinate_range,
        .t_interval = std::nullopt,
        .generator = cell.generator,
        .baseline = "exact",  // a round trip is compared with the curve that it started from, known exactly
        .mode = "",
        .values = std::vector<double>(static_cast<std::size_t>(study_.replicates))};
    return all.emplace_back(std::move(one));
  };
  each_row([&](const sample::Cell& cell, const Chain& chain, const ChainErrors& errors) {
    for (std::size_t i = 0; i < thresholds.size(); ++i) {
      auto& values = series_of(cell, chain, thresholds[i].column).values;
      for (const auto& [replicate, within] : errors.within)
        values.at(static_cast<std::size_t>(replicate)) += static_cast<double>(within[i]);
    }
  });
  return all;
}

std::unique_ptr<run::Job> conversion_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<ConversionJob>(study, context.seed);
}

constexpr std::array conversion_fields{suite::field<&suite::Study::published>(suite::published_key)};

}  // namespace

extern constexpr StudyKind conversion_kind{.asks = {.id = "conversion",
                                                    .about = "errors of the coefficients in another form",
                                                    .own = conversion_fields,
                                                    .methods_example = "[\"factorial+positive_sum\"]",
                                                    .inputs = {.forms = suite::polynomial_forms,
                                                               .forms_reason = "conversions take polynomial curves",
                                                               .double_only = true},
                                                    .chains = true},
                                           .make = conversion_job};

}  // namespace bezierbench::studies
