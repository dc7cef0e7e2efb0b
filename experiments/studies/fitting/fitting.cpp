// SPDX-License-Identifier: MIT
#include "experiments/studies/fitting/fitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/fit/kernel.hpp"
#include "experiments/judge/companions.hpp"
#include "experiments/judge/study_inputs.hpp"
#include "experiments/number/number.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/sample/data_kind.hpp"
#include "experiments/studies/fitting/fitting_tally.hpp"
#include "experiments/tables/cell_fields.hpp"
#include "reference/fit_distance.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::int64_t block_trials = 50;

using Methods = std::vector<const FittingKernel*>;

Methods methods_of(const suite::Study& study, int dimension) {
  Methods methods;
  const auto chosen = judge::chosen_companions(study, Problem::fitting);
  for (const auto& kernel : fitting_kernels(dimension))
    if (std::ranges::find(chosen, kernel.info) != chosen.end()) methods.push_back(&kernel);
  return methods;
}

/// One cell, number of data points and kind of data.
struct Part {
  sample::Cell cell;
  int points;
  const sample::DataKind* kind;
  sample::Sampler sampler;
  Methods methods;

  [[nodiscard]] std::vector<double> data(std::int64_t trial) const {
    return sample::data_points(*kind, sampler, cell, static_cast<std::uint64_t>(trial));
  }
};

/// An exact distance, squared; compares with a double without rounding.
struct SquaredDistance {
  reference::Rational value;

  [[nodiscard]] bool exceeds(double distance) const {
    const auto other = reference::exactly(distance);
    return sgn((value - other * other).numerator) > 0;
  }
};

SquaredDistance true_distance(const Fit& fit, int dimension, const std::vector<double>& data) {
  std::vector<reference::NearPlace> places;
  for (std::size_t i = 0; i < fit.t.size(); ++i) places.push_back({fit.segment[i], fit.t[i]});
  return {reference::largest_squared_distance(dimension, data, fit.control_points, places)};
}

void judge(const Fit& fit, int dimension, const std::vector<double>& data, double tolerance, std::uint64_t trial,
           FitErrors& errors) {
  const auto segments = static_cast<std::uint64_t>(fit.segments(dimension));
  const auto iterations = static_cast<std::uint64_t>(fit.iterations);
  errors.segments += segments;
  errors.most_segments = std::max(errors.most_segments, segments);
  errors.one_segment += segments == 1 ? 1 : 0;
  errors.iterations += iterations;
  errors.most_iterations = std::max(errors.most_iterations, iterations);
  errors.non_converged += fit.converged ? 0 : 1;
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!std::ranges::all_of(fit.control_points, finite) || !finite(fit.max_error)) {
    ++errors.non_finite;
    return;
  }
  const auto truth = true_distance(fit, dimension, data);
  errors.error.add(reference::square_root(reference::error_format, truth.value));
  errors.claimed.add(metric::to_24_bits(fit.max_error));
  errors.understated += truth.exceeds(fit.max_error) ? 1 : 0;
  if (!fit.converged || !truth.exceeds(tolerance)) return;
  ++errors.broken;
  errors.first_broken = std::min(errors.first_broken, trial);
}

class FittingJob final : public run::JobOf<FittingTally> {
 public:
  FittingJob(const suite::Study& study, std::uint64_t seed) : study_(study) {
    judge::check_inputs(study_);
    for (const auto& cell : sample::cells(study_))
      for (const int points : keys().points)
        for (const auto& kind : sample::data_kinds())
          parts_.push_back({cell, points, &kind,
                            sample::Sampler(seed, study_.id, sample::with_displacements(cell, points)),
                            methods_of(study_, cell.dimension)});
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override {
    return static_cast<std::size_t>((trials() - 1) / block_trials + 1);
  }
  [[nodiscard]] double cost(std::size_t part) const override {
    return static_cast<double>(std::min(trials(), block_trials)) * parts_[part].points * 50'000;
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (const Part& part : parts_) {
      const std::size_t rows = part.methods.size() * keys().tolerance.size();
      sum += {1, rows, static_cast<std::uint64_t>(trials()) * rows};
    }
    return sum;
  }
  void write(tables::Tables& tables) const override;
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }
  [[nodiscard]] std::vector<run::Violation> violations() const override;

 protected:
  [[nodiscard]] FittingTally work(std::size_t block) const override;

 private:
  [[nodiscard]] const suite::FittingKeys& keys() const { return suite::keys_of<suite::FittingKeys>(study_); }
  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }
  void write_example(tables::Tables& tables) const;

  suite::Study study_;
  std::vector<Part> parts_;
};

FittingTally FittingJob::work(std::size_t block) const {
  const Part& part = parts_[part_of(block)];
  FittingTally tally;
  tally.rows.resize(part.methods.size() * keys().tolerance.size());
  const auto first = static_cast<std::int64_t>(block % blocks_per_part()) * block_trials;
  const auto last = std::min(trials(), first + block_trials);
  for (auto trial = first; trial < last && !run::interrupted(); ++trial) {
    const auto data = part.data(trial);
    auto* row = tally.rows.data();
    for (const double tolerance : keys().tolerance)
      for (const auto* method : part.methods)
        judge(method->fit(data, tolerance), part.cell.dimension, data, tolerance, static_cast<std::uint64_t>(trial),
              *row++);
  }
  return tally;
}

const std::vector<std::string>& fitting_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> all = tables::cell_columns();
    all.insert(all.end(), {"data",          "points",          "tolerance",       "trials",
                           "status",        "mean_segments",   "max_segments",    "one_segment",
                           "mean_error",    "p50_error",       "max_error",       "max_error_over_tolerance",
                           "mean_claimed",  "max_claimed",     "mean_iterations", "max_iterations",
                           "non_converged", "broken_promises", "understated",     "non_finite"});
    return all;
  }();
  return columns;
}

/// The fields after `status`; a statistic of no trial is an empty field.
std::vector<std::string> statistics(const FitErrors& errors, double tolerance, std::int64_t trials) {
  const bool any = errors.error.count() > 0;
  const auto field = [any](double value) { return any ? number::decimal(value) : std::string(); };
  const auto mean = [trials](std::uint64_t sum) {
    return number::decimal(static_cast<double>(sum) / static_cast<double>(trials));
  };
  return {mean(errors.segments),
          std::to_string(errors.most_segments),
          std::to_string(errors.one_segment),
          field(errors.error.mean()),
          field(errors.error.quantile(0.5)),
          field(errors.error.max()),
          field(errors.error.max() / tolerance),
          field(errors.claimed.mean()),
          field(errors.claimed.max()),
          mean(errors.iterations),
          std::to_string(errors.most_iterations),
          std::to_string(errors.non_converged),
          std::to_string(errors.broken),
          std::to_string(errors.understated),
          std::to_string(errors.non_finite)};
}

void FittingJob::write(tables::Tables& tables) const {
  auto& table = tables.table("fitting.csv", fitting_columns());
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Part& part = parts_[p];
    std::size_t k = 0;
    for (const double tolerance : keys().tolerance)
      for (const auto* method : part.methods) {
        auto row = tables::cell_fields(study_, part.cell, method->info->id, suite::ScalarKind::float64);
        row.insert(row.end(), {std::string(part.kind->id), std::to_string(part.points), number::decimal(tolerance),
                               std::to_string(trials()), "ok"});
        for (auto& field : statistics(state(p).rows.at(k++), tolerance, trials())) row.push_back(std::move(field));
        table.add_row(std::move(row));
      }
  }
  write_example(tables);
}

/// Trial 0 of the first cell and number of points, in the plane, at the first tolerance: the data, without a method,
/// then what each method made of them.
void FittingJob::write_example(tables::Tables& tables) const {
  const auto first = std::ranges::find_if(parts_, [](const Part& part) { return part.cell.dimension == 2; });
  if (first == parts_.end()) return;
  auto& table =
      tables.table("fitting_example.csv", {"study", "data", "tolerance", "method", "segment", "index", "x", "y"});
  const double tolerance = keys().tolerance.front();
  for (auto part = first; part != parts_.end() && part->cell == first->cell && part->points == first->points; ++part) {
    const auto data = part->data(0);
    const auto add = [&](std::string_view method, const std::string& segment, std::size_t index, const double* point) {
      table.add_row({study_.id, std::string(part->kind->id), number::decimal(tolerance), std::string(method), segment,
                     std::to_string(index), number::decimal(point[0]), number::decimal(point[1])});
    };
    for (std::size_t i = 0; 2 * i < data.size(); ++i) add("", "", i, &data[2 * i]);
    for (const auto* method : part->methods) {
      const auto b = method->fit(data, tolerance).control_points;
      for (std::size_t i = 0; 2 * i < b.size(); ++i) add(method->info->id, std::to_string(i / 4), i % 4, &b[2 * i]);
    }
  }
}

std::vector<run::Violation> FittingJob::violations() const {
  std::vector<run::Violation> all;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    std::size_t k = 0;
    for (const double tolerance : keys().tolerance)
      for (const auto* method : parts_[p].methods) {
        const auto& errors = state(p).rows.at(k++);
        if (errors.broken == 0) continue;
        all.push_back(
            {fmt::format("{}, {} {} points, tolerance {}, method {}, first at trial {}",
                         tables::describe(study_, parts_[p].cell, suite::ScalarKind::float64), parts_[p].points,
                         parts_[p].kind->id, number::decimal(tolerance), method->info->id, errors.first_broken),
             errors.broken});
      }
  }
  return all;
}

}  // namespace

std::unique_ptr<run::Job> fitting_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<FittingJob>(study, context.seed);
}

}  // namespace bezierbench::studies
