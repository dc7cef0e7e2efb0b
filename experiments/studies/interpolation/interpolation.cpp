// SPDX-License-Identifier: MIT
#include "experiments/studies/interpolation/interpolation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/interpolate/kernel.hpp"
#include "experiments/judge/companions.hpp"
#include "experiments/judge/study_inputs.hpp"
#include "experiments/number/number.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/interpolation/interpolation_tally.hpp"
#include "experiments/studies/interpolation/spline_judge.hpp"
#include "experiments/tables/cell_fields.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::int64_t block_trials = 32;

using Methods = std::vector<const InterpolationKernel*>;

Methods methods_of(const suite::Study& study) {
  Methods methods;
  const auto chosen = judge::chosen_companions(study, Problem::interpolation);
  for (const auto& kernel : interpolation_kernels())
    if (std::ranges::find(chosen, kernel.info) != chosen.end()) methods.push_back(&kernel);
  return methods;
}

/// A number of points in one cell.
struct Part {
  sample::Cell cell;   ///< of the segments
  sample::Cell drawn;  ///< of the points: they are drawn as the control points of one curve

  [[nodiscard]] int points() const { return drawn.degree + 1; }
  [[nodiscard]] bool with_exact() const { return points() <= most_points_of_exact_splines; }
};

std::vector<Part> parts_of(suite::Study study) {
  for (const int points : suite::keys_of<suite::InterpolationKeys>(study).points) study.degree.push_back(points - 1);
  std::vector<Part> parts;
  for (const auto& drawn : sample::cells(study)) {
    parts.push_back({drawn, drawn});
    parts.back().cell.degree = 3;
  }
  return parts;
}

class InterpolationJob final : public run::JobOf<InterpolationTally> {
 public:
  InterpolationJob(const suite::Study& study, std::uint64_t seed) : study_(study), seed_(seed) {
    judge::check_inputs(study);
    methods_ = methods_of(study);
    parts_ = parts_of(study);
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override {
    return static_cast<std::size_t>((trials() - 1) / block_trials + 1);
  }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double k = parts_[part].points();
    const double per_point = 1500 + (parts_[part].with_exact() ? 1500 + 2 * k : 0);
    return static_cast<double>(std::min(trials(), block_trials)) * k * parts_[part].cell.dimension * per_point;
  }
  [[nodiscard]] run::Extent extent() const override {
    const std::size_t rows = parts_.size() * methods_.size();
    return {parts_.size(), rows, static_cast<std::uint64_t>(trials()) * rows};
  }
  void write(tables::Tables& tables) const override;
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }
  [[nodiscard]] std::vector<run::Violation> violations() const override;

 protected:
  [[nodiscard]] InterpolationTally work(std::size_t block) const override;

 private:
  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }

  suite::Study study_;
  std::uint64_t seed_;
  Methods methods_;
  std::vector<Part> parts_;
};

InterpolationTally InterpolationJob::work(std::size_t block) const {
  const Part& part = parts_[part_of(block)];
  const sample::Sampler sampler(seed_, study_.id, part.drawn);
  InterpolationTally tally;
  tally.methods.resize(methods_.size());
  sample::Trial drawn;
  const auto first = static_cast<std::int64_t>(block % blocks_per_part()) * block_trials;
  const auto last = std::min(trials(), first + block_trials);
  for (auto k = first; k < last && !run::interrupted(); ++k) {
    const auto trial = static_cast<std::uint64_t>(k);
    sampler.draw(trial, drawn);
    const SplineJudge judge(drawn.coefficients, part.cell.dimension, part.with_exact());
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      const InterpolationKernel& method = *methods_[m];
      judge.judge(method.interpolate(drawn.coefficients, part.cell.dimension), method.residual_bound, trial,
                  tally.methods[m]);
    }
  }
  return tally;
}

struct Column {
  const char* name;
  std::string (*field)(const SplineErrors& errors);
};

using Value = double (*)(const metric::Tally&);
constexpr Value mean = [](const metric::Tally& tally) { return tally.mean(); };
constexpr Value median = [](const metric::Tally& tally) { return tally.quantile(0.5); };
constexpr Value p99 = [](const metric::Tally& tally) { return tally.quantile(0.99); };
constexpr Value largest = [](const metric::Tally& tally) { return tally.max(); };

/// A statistic of no trial is an empty field.
template <metric::Tally SplineErrors::*Of, Value Which>
std::string statistic(const SplineErrors& errors) {
  return (errors.*Of).count() > 0 ? number::decimal(Which(errors.*Of)) : "";
}

constexpr Column columns[]{
    {"mean_error", statistic<&SplineErrors::error, mean>},
    {"p50_error", statistic<&SplineErrors::error, median>},
    {"p99_error", statistic<&SplineErrors::error, p99>},
    {"max_error", statistic<&SplineErrors::error, largest>},
    {"mean_error_u", statistic<&SplineErrors::error_u, mean>},
    {"max_error_u", statistic<&SplineErrors::error_u, largest>},
    {"max_data_u", statistic<&SplineErrors::data, largest>},
    {"max_c0_u", statistic<&SplineErrors::c0, largest>},
    {"mean_c1_u", statistic<&SplineErrors::c1, mean>},
    {"max_c1_u", statistic<&SplineErrors::c1, largest>},
    {"mean_c2_u", statistic<&SplineErrors::c2, mean>},
    {"p99_c2_u", statistic<&SplineErrors::c2, p99>},
    {"max_c2_u", statistic<&SplineErrors::c2, largest>},
    {"mean_natural_u", statistic<&SplineErrors::natural, mean>},
    {"max_natural_u", statistic<&SplineErrors::natural, largest>},
};

void InterpolationJob::write(tables::Tables& tables) const {
  auto names = tables::cell_columns();
  names.insert(names.end(), {"points", "trials", "status"});
  for (const auto& column : columns) names.emplace_back(column.name);
  names.insert(names.end(), {"bound_u", "bound_violations", "non_finite"});
  auto& table = tables.table("interpolation.csv", names);
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      const auto& errors = state(p).methods.at(m);
      const double bound = methods_[m]->residual_bound;
      auto row = tables::cell_fields(study_, parts_[p].cell, methods_[m]->info->id, suite::ScalarKind::float64);
      row.insert(row.end(), {std::to_string(parts_[p].points()), std::to_string(trials()), "ok"});
      for (const auto& column : columns) row.push_back(column.field(errors));
      row.insert(row.end(), {bound > 0 ? number::decimal(bound) : "",
                             bound > 0 ? std::to_string(errors.violations) : "", std::to_string(errors.non_finite)});
      table.add_row(std::move(row));
    }
}

std::vector<run::Violation> InterpolationJob::violations() const {
  std::vector<run::Violation> all;
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      const auto& errors = state(p).methods.at(m);
      if (errors.violations == 0) continue;
      all.push_back({fmt::format("{}, {} points, method {}, first at trial {}",
                                 tables::describe(study_, parts_[p].cell, suite::ScalarKind::float64),
                                 parts_[p].points(), methods_[m]->info->id, errors.first_violation),
                     errors.violations});
    }
  return all;
}

}  // namespace

std::unique_ptr<run::Job> interpolation_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<InterpolationJob>(study, context.seed);
}

}  // namespace bezierbench::studies
