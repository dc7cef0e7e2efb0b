// SPDX-License-Identifier: MIT
#include "experiments/studies/projection/projection.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/judge/companions.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/study_inputs.hpp"
#include "experiments/number/number.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/sample/placement.hpp"
#include "experiments/studies/projection/projection_tally.hpp"
#include "experiments/tables/cell_fields.hpp"
#include "reference/projection.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::int64_t block_trials = 100;

/// One cell and one way to place the point.
struct Part {
  sample::Cell cell;
  const sample::Placement* placement;
  sample::Sampler sampler;
  std::vector<const ProjectionKernel*> kernels;
};

/// |t - t*| for the nearest t* of those whose distance is the least, to a relative 2^-40.
double t_error(double t, const reference::ExactProjection& exact) {
  constexpr double tie = 1 + 0x1p-40;
  const auto distance = [](const reference::CriticalPoint& point) {
    return reference::square_root(reference::binary64, point.distance_squared);
  };
  const double least = distance(exact.foot());
  double error = 1;
  for (const auto& critical : exact.critical)
    if (distance(critical) <= least * tie)
      error = std::min(error, reference::round_to(reference::error_format, abs(reference::exactly(t) - critical.t)));
  return error;
}

class ProjectionJob final : public run::JobOf<ProjectionTallies> {
 public:
  ProjectionJob(const suite::Study& study, std::uint64_t seed)
      : study_(study), infos_(judge::chosen_companions(study, Problem::projection)) {
    judge::check_inputs(study_);
    for (const auto& cell : sample::cells(study_))
      for (const auto& placement : sample::placements())
        parts_.push_back(
            {cell, &placement, sample::Sampler(seed, study_.id, sample::with_point(cell)), kernels_of(cell.dimension)});
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override {
    return static_cast<std::size_t>((trials() - 1) / block_trials + 1);
  }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double n = parts_[part].cell.degree;
    return static_cast<double>(std::min(trials(), block_trials)) * 20'000 * n * n;
  }
  [[nodiscard]] run::Extent extent() const override {
    const auto rows = parts_.size() * infos_.size();
    return {parts_.size(), rows, rows * static_cast<std::uint64_t>(trials())};
  }
  void write(tables::Tables& tables) const override;
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }

 protected:
  [[nodiscard]] ProjectionTallies work(std::size_t block) const override;

 private:
  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }
  [[nodiscard]] std::vector<const ProjectionKernel*> kernels_of(int dimension) const {
    std::vector<const ProjectionKernel*> kernels;
    for (const auto* info : infos_)
      for (const auto& kernel : judge::projection_methods(dimension))
        if (kernel.info == info) kernels.push_back(&kernel);
    return kernels;
  }
  static void judge(const ProjectionKernel& kernel, const sample::PlacedPoint& problem,
                    const reference::ExactProjection& exact, ProjectionTally& tally);

  suite::Study study_;
  std::vector<const MethodInfo*> infos_;
  std::vector<Part> parts_;
};

void ProjectionJob::judge(const ProjectionKernel& kernel, const sample::PlacedPoint& problem,
                          const reference::ExactProjection& exact, ProjectionTally& tally) {
  const auto foot = kernel.project({Form::bernstein, problem.dimension, problem.degree, problem.points}, problem.point);
  tally.candidates += static_cast<std::uint64_t>(foot.candidates);
  tally.most_candidates = std::max(tally.most_candidates, static_cast<std::uint64_t>(foot.candidates));
  tally.non_converged += foot.converged ? 0 : 1;
  if (!std::isfinite(foot.distance) || !std::isfinite(foot.t)) {
    ++tally.non_finite;
    return;
  }
  const double error = reference::foot_error(reference::error_format, foot.t, foot.distance, exact);
  const double largest = sample::largest_coordinate(problem);
  tally.error.add(error);
  tally.error_unit.add(error == 0 ? 0 : metric::to_24_bits(error / largest * 0x1p+52));
  tally.t_error.add(t_error(foot.t, exact));
  tally.missed += error > missed_tolerance * largest ? 1 : 0;
}

ProjectionTallies ProjectionJob::work(std::size_t block) const {
  const auto& part = parts_[part_of(block)];
  ProjectionTallies tallies;
  tallies.methods.resize(infos_.size());
  const auto first = static_cast<std::int64_t>(block % blocks_per_part()) * block_trials;
  const auto last = std::min(first + block_trials, trials());
  for (auto trial = first; trial < last && !run::interrupted(); ++trial) {
    const auto problem = sample::place(*part.placement, part.sampler, part.cell, static_cast<std::uint64_t>(trial));
    if (problem.degree < 1) break;
    const auto exact =
        reference::projection({Form::bernstein, problem.dimension, problem.degree, problem.points}, problem.point);
    for (std::size_t m = 0; m < part.kernels.size(); ++m)
      if (infos_[m]->supports<double>(problem.degree)) judge(*part.kernels[m], problem, exact, tallies.methods[m]);
  }
  return tallies;
}

struct Column {
  const char* name;
  std::string (*field)(const ProjectionTally& tally);
};

using Value = double (*)(const metric::Tally&);
constexpr Value mean = [](const metric::Tally& tally) { return tally.mean(); };
constexpr Value median = [](const metric::Tally& tally) { return tally.quantile(0.5); };
constexpr Value p99 = [](const metric::Tally& tally) { return tally.quantile(0.99); };
constexpr Value largest = [](const metric::Tally& tally) { return tally.max(); };

/// A statistic of no trial is an empty field.
template <metric::Tally ProjectionTally::*Of, Value Which>
std::string statistic(const ProjectionTally& tally) {
  return (tally.*Of).count() > 0 ? number::decimal(Which(tally.*Of)) : "";
}

template <std::uint64_t ProjectionTally::*Of>
std::string count(const ProjectionTally& tally) {
  return std::to_string(tally.*Of);
}

constexpr Column columns[]{
    {"missed", count<&ProjectionTally::missed>},
    {"mean_error", statistic<&ProjectionTally::error, mean>},
    {"p50_error", statistic<&ProjectionTally::error, median>},
    {"p99_error", statistic<&ProjectionTally::error, p99>},
    {"max_error", statistic<&ProjectionTally::error, largest>},
    {"mean_error_eps", statistic<&ProjectionTally::error_unit, mean>},
    {"max_error_eps", statistic<&ProjectionTally::error_unit, largest>},
    {"mean_t_error", statistic<&ProjectionTally::t_error, mean>},
    {"p50_t_error", statistic<&ProjectionTally::t_error, median>},
    {"max_t_error", statistic<&ProjectionTally::t_error, largest>},
    {"candidates", count<&ProjectionTally::candidates>},
    {"max_candidates", count<&ProjectionTally::most_candidates>},
    {"non_converged", count<&ProjectionTally::non_converged>},
    {"non_finite", count<&ProjectionTally::non_finite>},
};

void ProjectionJob::write(tables::Tables& tables) const {
  auto names = tables::cell_columns();
  names.insert(names.end(), {"placement", "trials", "status"});
  for (const auto& column : columns) names.emplace_back(column.name);
  for (std::size_t part = 0; part < parts_.size(); ++part)
    for (std::size_t m = 0; m < infos_.size(); ++m) {
      const auto& cell = parts_[part].cell;
      auto row = tables::cell_fields(study_, cell, infos_[m]->id, suite::ScalarKind::float64);
      const bool supported = infos_[m]->supports<double>(cell.degree);
      row.insert(row.end(), {std::string(parts_[part].placement->id), std::to_string(trials()),
                             supported ? "ok" : "degree_unsupported"});
      if (supported)
        for (const auto& column : columns) row.push_back(column.field(state(part).methods.at(m)));
      row.resize(names.size());
      tables.table(infos_[m]->bit_stable ? "projection.csv" : "projection_unstable.csv", names).add_row(std::move(row));
    }
}

}  // namespace

std::unique_ptr<run::Job> projection_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<ProjectionJob>(study, context.seed);
}

}  // namespace bezierbench::studies
