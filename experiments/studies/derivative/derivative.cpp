// SPDX-License-Identifier: MIT
#include "experiments/studies/derivative/derivative.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/derivative/kernel.hpp"
#include "experiments/judge/companions.hpp"
#include "experiments/judge/method_choice.hpp"
#include "experiments/judge/study_inputs.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "experiments/number/number.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/derivative/derivative_tally.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::int64_t block_trials = 512;

using Methods = std::vector<const DerivativeKernel*>;

/// The methods of the study that take its form of curve, in roster order.
Methods methods_of(const suite::Study& study, int dimension) {
  Methods methods;
  const auto chosen = judge::chosen_companions(study, Problem::derivative);
  for (const auto& kernel : derivative_kernels(dimension))
    if (kernel.info->form == study.curve && std::ranges::find(chosen, kernel.info) != chosen.end())
      methods.push_back(&kernel);
  judge::require_form(study, !methods.empty());
  return methods;
}

/// One order in one cell.
struct Part {
  sample::Cell cell;
  int order;
  Methods methods;
};

/// Scratch of one thread.
struct Scratch {
  sample::Trial trial;
  reference::ExactCurve exact;
  metric::DerivativeScale scale;
  std::vector<double> point;
};

/// Infinite where it overflows.
void add_rounded(double value, metric::Tally& tally) {
  const double rounded = metric::to_24_bits(value);
  if (std::isfinite(rounded))
    tally.add(rounded);
  else
    tally.add_infinite();
}

class DerivativeJob final : public run::JobOf<DerivativeTally> {
 public:
  DerivativeJob(const suite::Study& study, std::uint64_t seed) : study_(study), seed_(seed) {
    judge::check_inputs(study);
    for (const auto& cell : sample::cells(study_))
      for (const int order : suite::keys_of<suite::DerivativeKeys>(study_).order)
        parts_.push_back({cell, order, methods_of(study_, cell.dimension)});
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override {
    return static_cast<std::size_t>((trials() - 1) / block_trials + 1);
  }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double n = parts_[part].cell.degree + 1.0;
    return static_cast<double>(std::min(trials(), block_trials)) *
           (400 + n * n * (20 + 2 * static_cast<double>(parts_[part].methods.size())));
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (const Part& part : parts_)
      sum += {1, part.methods.size(), static_cast<std::uint64_t>(trials()) * part.methods.size()};
    return sum;
  }
  void write(tables::Tables& tables) const override;
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }
  [[nodiscard]] std::vector<run::Violation> violations() const override;

 protected:
  [[nodiscard]] DerivativeTally work(std::size_t block) const override;

 private:
  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }
  static void judge(const Part& part, Form form, std::uint64_t trial, Scratch& scratch, DerivativeTally& tally);

  suite::Study study_;
  std::uint64_t seed_;
  std::vector<Part> parts_;
};

DerivativeTally DerivativeJob::work(std::size_t block) const {
  thread_local Scratch scratch;
  const Part& part = parts_[part_of(block)];
  const sample::Sampler sampler(seed_, study_.id, part.cell);
  DerivativeTally tally;
  tally.methods.resize(part.methods.size());
  const auto first = static_cast<std::int64_t>(block % blocks_per_part()) * block_trials;
  const auto last = std::min(trials(), first + block_trials);
  for (auto k = first; k < last && !run::interrupted(); ++k) {
    const auto trial = static_cast<std::uint64_t>(k);
    sampler.draw(trial, scratch.trial);
    judge(part, study_.curve, trial, scratch, tally);
  }
  return tally;
}

void DerivativeJob::judge(const Part& part, Form form, std::uint64_t trial, Scratch& scratch, DerivativeTally& tally) {
  const CurveView<double> curve{form, part.cell.dimension, part.cell.degree, scratch.trial.coefficients};
  const double t = scratch.trial.t;
  scratch.scale.set(curve, part.order, t);
  scratch.point.resize(static_cast<std::size_t>(part.cell.dimension));
  const reference::Distance distance(scratch.exact.derivative(curve, part.order, t));
  for (std::size_t m = 0; m < part.methods.size(); ++m) {
    const DerivativeKernel& method = *part.methods[m];
    DerivativeErrors& errors = tally.methods[m];
    if (!method.info->supports<double>(part.cell.degree)) continue;
    method.derivative(curve, part.order, t, scratch.point.data());
    const double error = distance.to(scratch.point);
    if (!std::isfinite(error)) {
      ++errors.non_finite;
      continue;
    }
    errors.error.add(error);
    add_rounded(scratch.scale.in_bound_units(error, metric::double_arithmetic), errors.error_u);
    if (method.bound == nullptr) continue;
    const double bound = scratch.scale.bound(*method.bound, metric::double_arithmetic);
    if (!std::isfinite(bound)) continue;  // nothing is proved here
    ++errors.bounded;
    const double bound_u = scratch.scale.in_bound_units(bound, metric::double_arithmetic);
    if (std::isfinite(bound_u)) errors.bound_u = std::max(errors.bound_u, bound_u);
    if (!metric::TrialScale::violates(error, bound)) continue;
    ++errors.violations;
    errors.first_violation = std::min(errors.first_violation, trial);
  }
}

const std::vector<std::string>& derivative_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> all = tables::cell_columns();
    all.insert(all.end(), {"order", "trials", "status", "mean_error", "p50_error", "p99_error", "max_error",
                           "mean_error_u", "max_error_u", "bound_u", "bound_violations", "non_finite"});
    return all;
  }();
  return columns;
}

/// The fields after `status`; a statistic of no trial is an empty field.
std::vector<std::string> statistics(const DerivativeErrors& errors) {
  const bool any = errors.error.count() > 0;
  const auto field = [any](double value) { return any ? number::decimal(value) : std::string(); };
  return {field(errors.error.mean()),
          field(errors.error.quantile(0.5)),
          field(errors.error.quantile(0.99)),
          field(errors.error.max()),
          field(errors.error_u.mean()),
          field(errors.error_u.max()),
          errors.bounded > 0 ? number::decimal(errors.bound_u) : "",
          errors.bounded > 0 ? std::to_string(errors.violations) : "",
          std::to_string(errors.non_finite)};
}

void DerivativeJob::write(tables::Tables& tables) const {
  auto& table = tables.table("derivative.csv", derivative_columns());
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Part& part = parts_[p];
    for (std::size_t m = 0; m < part.methods.size(); ++m) {
      auto row = tables::cell_fields(study_, part.cell, part.methods[m]->info->id, suite::ScalarKind::float64);
      row.insert(row.end(), {std::to_string(part.order), std::to_string(trials())});
      if (part.methods[m]->info->supports<double>(part.cell.degree)) {
        row.emplace_back("ok");
        for (auto& field : statistics(state(p).methods.at(m))) row.push_back(std::move(field));
      } else {
        row.emplace_back("degree_unsupported");
        row.resize(derivative_columns().size());
      }
      table.add_row(std::move(row));
    }
  }
}

std::vector<run::Violation> DerivativeJob::violations() const {
  std::vector<run::Violation> all;
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (std::size_t m = 0; m < parts_[p].methods.size(); ++m) {
      const auto& errors = state(p).methods.at(m);
      if (errors.violations == 0) continue;
      all.push_back({fmt::format("{}, order {}, method {}, first at trial {}",
                                 tables::describe(study_, parts_[p].cell, suite::ScalarKind::float64), parts_[p].order,
                                 parts_[p].methods[m]->info->id, errors.first_violation),
                     errors.violations});
    }
  return all;
}

}  // namespace

std::unique_ptr<run::Job> derivative_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<DerivativeJob>(study, context.seed);
}

}  // namespace bezierbench::studies
