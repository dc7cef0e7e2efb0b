// SPDX-License-Identifier: MIT
#include "experiments/studies/arc_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/arc_length_tally.hpp"
#include "experiments/studies/cell_fields.hpp"
#include "experiments/studies/companions.hpp"
#include "experiments/studies/interruption.hpp"
#include "experiments/studies/methods.hpp"
#include "experiments/suite/names.hpp"
#include "reference/true_length.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::int64_t block_trials = 16;  // true lengths take a while

using Methods = std::vector<const ArcLengthKernel*>;

void check(const suite::Study& study) {
  const auto refuse = [&](const std::string& what) {
    throw Failure(Exit::usage, fmt::format("study \"{}\": {}", study.id, what));
  };
  if (study.curve != suite::CurveKind::bezier)
    refuse("lengths are those of polynomial Bezier curves; write curve = \"bezier\"");
  if (std::ranges::any_of(study.scalar, [](auto scalar) { return scalar != suite::ScalarKind::float64; }))
    refuse("lengths are computed in double only; leave scalar out");
  for (const auto& t : study.t_interval)
    if (t.min < 0 || t.max > 1)
      refuse(fmt::format("t_interval {}:{} is the part to be measured and must be within 0 and 1",
                         number::decimal(t.min), number::decimal(t.max)));
}

Methods methods_of(const suite::Study& study, int dimension) {
  Methods methods;
  const auto chosen = chosen_companions(study, Problem::arc_length);
  for (const auto& kernel : arc_length_methods(dimension))
    if (std::ranges::find(chosen, kernel.info) != chosen.end()) methods.push_back(&kernel);
  return methods;
}

/// One cell.
struct Part {
  sample::Cell cell;
  Methods methods;
};

class ArcLengthJob final : public JobOf<ArcLengthTally> {
 public:
  ArcLengthJob(const suite::Study& study, std::uint64_t seed) : study_(study), seed_(seed) {
    check(study);
    for (const auto& cell : sample::cells(study_)) parts_.push_back({cell, methods_of(study_, cell.dimension)});
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override {
    return static_cast<std::size_t>((trials() - 1) / block_trials + 1);
  }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double n = parts_[part].cell.degree + 1.0;
    return static_cast<double>(std::min(trials(), block_trials)) * 1e6 * n * n;
  }
  [[nodiscard]] Extent extent() const override {
    Extent sum;
    constexpr std::size_t tallies = 200'000;  // two histograms of some fifty binades
    for (const Part& part : parts_) {
      const std::size_t rows = part.methods.size() * study_.tolerance.size();
      sum += {1, rows, static_cast<std::uint64_t>(trials()) * rows, rows * tallies};
    }
    return sum;
  }
  void write(Tables& tables) const override;
  [[nodiscard]] std::vector<Series> series() const override { return {}; }
  [[nodiscard]] std::vector<Violation> violations() const override;

 protected:
  [[nodiscard]] ArcLengthTally work(std::size_t block) const override;

 private:
  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }
  void judge(const Part& part, const sample::Trial& drawn, std::uint64_t trial, ArcLengthTally& tally) const;

  suite::Study study_;
  std::uint64_t seed_;
  std::vector<Part> parts_;
};

ArcLengthTally ArcLengthJob::work(std::size_t block) const {
  const Part& part = parts_[part_of(block)];
  const sample::Sampler sampler(seed_, study_.id, part.cell);
  ArcLengthTally tally;
  tally.rows.resize(part.methods.size() * study_.tolerance.size());
  sample::Trial drawn;
  const auto first = static_cast<std::int64_t>(block % blocks_per_part()) * block_trials;
  const auto last = std::min(trials(), first + block_trials);
  for (auto trial = first; trial < last && !interrupted(); ++trial) {
    sampler.draw(static_cast<std::uint64_t>(trial), drawn);
    judge(part, drawn, static_cast<std::uint64_t>(trial), tally);
  }
  return tally;
}

void ArcLengthJob::judge(const Part& part, const sample::Trial& drawn, std::uint64_t trial,
                         ArcLengthTally& tally) const {
  const CurveView<double> curve{Form::bernstein, part.cell.dimension, part.cell.degree, drawn.coefficients};
  const auto [from, to] = part.cell.t_interval;
  const reference::TrueLength truth(curve, from, to);
  const auto length = truth.value().convert_to<double>();
  auto* row = tally.rows.data();
  for (const double tolerance : study_.tolerance)
    for (const auto* method : part.methods) {
      LengthErrors& errors = *row++;
      const auto result = method->measure(curve, from, to, tolerance);
      const auto evaluations = static_cast<std::uint64_t>(result.evaluations);
      errors.evaluations += evaluations;
      errors.most_evaluations = std::max(errors.most_evaluations, evaluations);
      errors.non_converged += result.converged ? 0 : 1;
      const double error = metric::to_24_bits(truth.error_of(result.length));
      if (!std::isfinite(error)) {
        ++errors.non_finite;
        continue;
      }
      errors.error.add(error);
      errors.relative.add(error == 0 ? 0 : metric::to_24_bits(error / length));
      if (!result.converged || error <= tolerance * length * (1 + 0x1p-20)) continue;
      ++errors.broken;
      errors.first_broken = std::min(errors.first_broken, trial);
    }
}

const std::vector<std::string>& arc_length_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> all = cell_columns();
    all.insert(all.end(), {"tolerance", "trials", "status", "mean_error", "p50_error", "p99_error", "max_error",
                           "mean_relative", "max_relative", "mean_evaluations", "max_evaluations", "non_converged",
                           "broken_promises", "non_finite"});
    return all;
  }();
  return columns;
}

/// The fields after `status`; a statistic of no trial is an empty field.
std::vector<std::string> statistics(const LengthErrors& errors, std::int64_t trials) {
  const bool any = errors.error.count() > 0;
  const auto field = [any](double value) { return any ? number::decimal(value) : std::string(); };
  return {field(errors.error.mean()),
          field(errors.error.quantile(0.5)),
          field(errors.error.quantile(0.99)),
          field(errors.error.max()),
          field(errors.relative.mean()),
          field(errors.relative.max()),
          number::decimal(static_cast<double>(errors.evaluations) / static_cast<double>(trials)),
          std::to_string(errors.most_evaluations),
          std::to_string(errors.non_converged),
          std::to_string(errors.broken),
          std::to_string(errors.non_finite)};
}

void ArcLengthJob::write(Tables& tables) const {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    std::size_t k = 0;
    for (const double tolerance : study_.tolerance)
      for (const auto* method : parts_[p].methods) {
        auto row = cell_fields(study_, parts_[p].cell, method->info->id, suite::ScalarKind::float64);
        row.insert(row.end(), {number::decimal(tolerance), std::to_string(trials()), "ok"});
        for (auto& field : statistics(state(p).rows.at(k++), trials())) row.push_back(std::move(field));
        const bool stable = method->info->bit_stable;
        tables.table(stable ? "arc_length.csv" : "arc_length_unstable.csv", arc_length_columns())
            .add_row(std::move(row));
      }
  }
}

std::vector<Violation> ArcLengthJob::violations() const {
  std::vector<Violation> all;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    std::size_t k = 0;
    for (const double tolerance : study_.tolerance)
      for (const auto* method : parts_[p].methods) {
        const auto& errors = state(p).rows.at(k++);
        if (errors.broken == 0) continue;
        all.push_back({fmt::format("{}, tolerance {}, method {}, first at trial {}",
                                   describe(study_, parts_[p].cell, suite::ScalarKind::float64),
                                   number::decimal(tolerance), method->info->id, errors.first_broken),
                       errors.broken});
      }
  }
  return all;
}

}  // namespace

std::unique_ptr<Job> arc_length_job(const suite::Study& study, const JobContext& context) {
  return std::make_unique<ArcLengthJob>(study, context.seed);
}

}  // namespace bezierbench::studies
