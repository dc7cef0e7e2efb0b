// SPDX-License-Identifier: MIT
#include "experiments/studies/subdivision/subdivision.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/judge/companions.hpp"
#include "experiments/judge/method_choice.hpp"
#include "experiments/judge/study_inputs.hpp"
#include "experiments/number/number.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/subdivision/split_judge.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::int64_t block_trials = 64;

using Methods = std::vector<const SplitKernel*>;

/// The methods of the study that take its form of curve, in roster order.
Methods methods_of(const suite::Study& study, int dimension) {
  Methods methods;
  const auto chosen = judge::chosen_companions(study, Problem::subdivision);
  for (const auto& kernel : split_kernels(dimension))
    if (kernel.info->form == study.curve && std::ranges::find(chosen, kernel.info) != chosen.end())
      methods.push_back(&kernel);
  judge::require_form(study, !methods.empty());
  return methods;
}

struct Part {
  sample::Cell cell;
  Methods methods;
};

class SubdivisionJob final : public run::JobOf<SubdivisionTally> {
 public:
  SubdivisionJob(const suite::Study& study, std::uint64_t seed) : study_(study), seed_(seed) {
    judge::check_inputs(study);
    for (const auto& cell : sample::cells(study_)) parts_.push_back({cell, methods_of(study_, cell.dimension)});
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override {
    return static_cast<std::size_t>((trials() - 1) / block_trials + 1);
  }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double n = parts_[part].cell.degree + 1.0;
    const auto methods = static_cast<double>(parts_[part].methods.size());
    return static_cast<double>(std::min(trials(), block_trials)) * n * (5000 + 500 * n + 1000 * methods);
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
  [[nodiscard]] SubdivisionTally work(std::size_t block) const override;

 private:
  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }

  suite::Study study_;
  std::uint64_t seed_;
  std::vector<Part> parts_;
};

SubdivisionTally SubdivisionJob::work(std::size_t block) const {
  const Part& part = parts_[part_of(block)];
  const sample::Sampler sampler(seed_, study_.id, part.cell);
  SubdivisionTally tally;
  tally.methods.resize(part.methods.size());
  const auto first = static_cast<std::int64_t>(block % blocks_per_part()) * block_trials;
  const auto last = std::min(trials(), first + block_trials);
  sample::Trial drawn;
  for (auto k = first; k < last && !run::interrupted(); ++k) {
    const auto trial = static_cast<std::uint64_t>(k);
    sampler.draw(trial, drawn);
    const CurveView<double> curve{study_.curve, part.cell.dimension, part.cell.degree, drawn.coefficients,
                                  drawn.weights};
    const SplitTruth truth(curve, drawn.t);
    for (std::size_t m = 0; m < part.methods.size(); ++m)
      if (part.methods[m]->info->supports<double>(part.cell.degree))
        judge_split(*part.methods[m], curve, drawn.t, truth, trial, tally.methods[m]);
  }
  return tally;
}

const std::vector<std::string>& subdivision_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> all = tables::cell_columns();
    all.insert(all.end(), {"trials", "status", "mean_error", "p50_error", "p99_error", "max_error", "mean_error_u",
                           "max_error_u", "max_weight_error_u", "bound_u", "bound_violations", "junctions_apart",
                           "ends_moved", "points_off", "non_finite"});
    return all;
  }();
  return columns;
}

/// The fields after `status`; a statistic of no trial is an empty field.
std::vector<std::string> statistics(const SubdivisionErrors& errors, Form form) {
  const bool any = errors.error.count() > 0;
  const auto field = [any](double value) { return any ? number::decimal(value) : std::string(); };
  return {field(errors.error.mean()),
          field(errors.error.quantile(0.5)),
          field(errors.error.quantile(0.99)),
          field(errors.error.max()),
          field(errors.error_u.mean()),
          field(errors.error_u.max()),
          form == Form::rational ? field(errors.weight_error_u) : "",
          errors.bounded > 0 ? number::decimal(errors.bound_u) : "",
          errors.bounded > 0 ? std::to_string(errors.violations.count) : "",
          any ? std::to_string(errors.junctions_apart.count) : "",
          any ? std::to_string(errors.ends_moved.count) : "",
          errors.middles > 0 ? std::to_string(errors.points_off.count) : "",
          std::to_string(errors.non_finite)};
}

void SubdivisionJob::write(tables::Tables& tables) const {
  auto& table = tables.table("subdivision.csv", subdivision_columns());
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Part& part = parts_[p];
    for (std::size_t m = 0; m < part.methods.size(); ++m) {
      const MethodInfo& info = *part.methods[m]->info;
      auto row = tables::cell_fields(study_, part.cell, info.id, suite::ScalarKind::float64);
      row.push_back(std::to_string(trials()));
      if (info.supports<double>(part.cell.degree)) {
        row.emplace_back("ok");
        for (auto& field : statistics(state(p).methods.at(m), info.form)) row.push_back(std::move(field));
      } else {
        row.emplace_back("degree_unsupported");
        row.resize(subdivision_columns().size());
      }
      table.add_row(std::move(row));
    }
  }
}

std::vector<run::Violation> SubdivisionJob::violations() const {
  std::vector<run::Violation> all;
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (std::size_t m = 0; m < parts_[p].methods.size(); ++m) {
      const auto& errors = state(p).methods.at(m);
      const auto add = [&](const TrialCount& trials, const char* what) {
        if (trials.count == 0) return;
        all.push_back({fmt::format("{}, method {}, {}, first at trial {}",
                                   tables::describe(study_, parts_[p].cell, suite::ScalarKind::float64),
                                   parts_[p].methods[m]->info->id, what, trials.first),
                       trials.count});
      };
      add(errors.violations, "control points");
      add(errors.broken_promises, "promise of ends or junction");
      add(errors.points_off, "points of a half");
    }
  return all;
}

}  // namespace

std::unique_ptr<run::Job> subdivision_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<SubdivisionJob>(study, context.seed);
}

}  // namespace bezierbench::studies
