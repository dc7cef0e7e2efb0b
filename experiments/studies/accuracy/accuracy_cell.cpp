// SPDX-License-Identifier: MIT
#include "experiments/studies/accuracy/accuracy_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/judge/input_fields.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/judge/trial_inputs.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {

namespace {

using tables::field;
using tables::largest;
using tables::mean;
using tables::median;
using tables::p99;
using tables::root_mean_square;
using tables::Statistic;

struct Column {
  const char* name;
  tables::Field (*field)(const Statistics& of);
};

template <auto Member, Statistic Of>
constexpr auto judgement_field = [](const Statistics& s) { return field(s.judgement.*Member, Of); };
template <auto Member, Statistic Of>
constexpr auto source_field = [](const Statistics& s) { return field(s.judgement.sources.*Member, Of); };
template <Statistic Of>
constexpr auto condition_field = [](const Statistics& s) { return s.exact ? field(s.condition, Of) : tables::Field(); };

constexpr Column columns[]{
    {"mean_error", judgement_field<&judge::Judgement::error, mean>},
    {"rms_error", judgement_field<&judge::Judgement::error, root_mean_square>},
    {"p50_error", judgement_field<&judge::Judgement::error, median>},
    {"p99_error", judgement_field<&judge::Judgement::error, p99>},
    {"max_error", judgement_field<&judge::Judgement::error, largest>},
    {"mean_error_u", judgement_field<&judge::Judgement::error_u, mean>},
    {"max_error_u", judgement_field<&judge::Judgement::error_u, largest>},
    {"bound_u", [](const Statistics& s) { return s.bounded() ? field(s.judgement.bound_u) : tables::Field(); }},
    {"bound_violations",
     [](const Statistics& s) { return s.bounded() ? field(s.judgement.violations) : tables::Field(); }},
    {"non_finite", [](const Statistics& s) { return field(s.judgement.non_finite); }},
    {"mean_error_ulp", judgement_field<&judge::Judgement::error_ulp, mean>},
    {"max_error_ulp", judgement_field<&judge::Judgement::error_ulp, largest>},
    {"mean_relative", judgement_field<&judge::Judgement::relative, mean>},
    {"p50_relative", judgement_field<&judge::Judgement::relative, median>},
    {"max_relative", judgement_field<&judge::Judgement::relative, largest>},
    {"p50_condition", condition_field<median>},
    {"max_condition", condition_field<largest>},
    {"mean_conversion_error", source_field<&judge::SourceTallies::conversion, mean>},
    {"max_conversion_error", source_field<&judge::SourceTallies::conversion, largest>},
    {"mean_one_minus_t_error", source_field<&judge::SourceTallies::one_minus_t, mean>},
    {"max_one_minus_t_error", source_field<&judge::SourceTallies::one_minus_t, largest>},
    {"mean_evaluation_error", source_field<&judge::SourceTallies::evaluation, mean>},
    {"max_evaluation_error", source_field<&judge::SourceTallies::evaluation, largest>},
    {"max_bound", [](const Statistics& s) { return s.bounded() ? field(s.judgement.bound) : tables::Field(); }},
    {"unbounded_trials",
     [](const Statistics& s) {
       return s.exact ? field(s.trials - static_cast<std::int64_t>(s.judgement.bounded)) : tables::Field();
     }},
    {"misrounded",
     [](const Statistics& s) {
       return s.judgement.coordinates > 0 ? tables::Field(static_cast<double>(s.judgement.misrounded) /
                                                          static_cast<double>(s.judgement.coordinates))
                                          : tables::Field();
     }},
    {"mean_error_size", judgement_field<&judge::Judgement::error_size, mean>},
    {"p99_error_size", judgement_field<&judge::Judgement::error_size, p99>},
    {"max_error_size", judgement_field<&judge::Judgement::error_size, largest>}};

}  // namespace

void set_statistics(tables::Row& row, const Statistics& statistics) {
  for (const Column& column : columns) row.set(column.name, column.field(statistics));
}

namespace {

constexpr std::int64_t block_trials = 1024;

/// One statistic of a judgement over the replicates that have it.
std::vector<double> over_replicates(const judge::CellTally& tally, std::size_t judgement,
                                    double judge::ReplicateStatistic::*which) {
  std::vector<double> values;
  for (const auto& [replicate, statistics] : tally.replicates.closed)
    if (const double value = statistics.at(judgement).*which; !std::isnan(value)) values.push_back(value);
  return values;
}

}  // namespace

template <class Scalar>
AccuracyCell<Scalar>::AccuracyCell(const suite::Study& study, const run::JobContext& context, const sample::Cell& cell)
    : study_(study),
      cell_(cell),
      blocks_(study.trials, study.replicates, block_trials),
      tier_(context.tier),
      sampler_(context.seed, study.id, cell),
      methods_(study, cell),
      judge_(study_, cell_, sampler_, methods_, tier_, context.audited_trials) {}

template <class Scalar>
AccuracyCell<Scalar>::AccuracyCell(const suite::Study& study, const run::JobContext& context, const sample::Cell& cell,
                                   const Kernel<Scalar>& method)
    : study_(study),
      cell_(cell),
      blocks_(study.trials, study.replicates, block_trials),
      tier_(context.tier),
      sampler_(context.seed, study.id, cell),
      methods_(study, cell, method),
      judge_(study_, cell_, sampler_, methods_, tier_, context.audited_trials) {}

template <class Scalar>
double AccuracyCell<Scalar>::cost() const {
  const double n = cell_.degree + 1.0;
  return static_cast<double>(blocks_.full()) * (200 + n * 150 + n * n * 2 * static_cast<double>(methods_.count()));
}

template <class Scalar>
run::Extent AccuracyCell<Scalar>::extent() const {
  const auto rows = methods_.judgement_count();
  return {1, 2 * rows, static_cast<std::uint64_t>(trials()) * methods_.count()};  // of accuracy.csv and worst.csv
}

template <class Scalar>
std::pair<std::uint64_t, std::uint64_t> AccuracyCell<Scalar>::trials_of(std::size_t block) const {
  const auto [replicate, first, end] = blocks_[block];
  const auto before = replicate * study_.trials;
  return {static_cast<std::uint64_t>(before + first), static_cast<std::uint64_t>(before + end)};
}

template <class Scalar>
judge::CellTally AccuracyCell<Scalar>::empty_block() const {
  judge::CellTally work;
  work.replicates.blocks_of_each = static_cast<std::uint64_t>(blocks_.per_replicate());
  work.judgements.resize(methods_.judgement_count());
  return work;
}

template <class Scalar>
judge::CellTally AccuracyCell<Scalar>::run_block(std::size_t block) const {
  const auto trials = blocks_[block];
  auto work = empty_block();
  run::each_group(trials, judge::trials_at_once, [&](std::int64_t trial, std::int64_t count) {
    judge_.judge({trials.replicate, trial}, count, trial == trials.first, work);
  });
  work.end_block(trials.replicate);
  return work;
}

template <class Scalar>
judge::CellTally AccuracyCell<Scalar>::judge_block(std::size_t block, std::span<const double> points) const {
  auto trials = blocks_[block];
  const auto d = static_cast<std::size_t>(cell_.dimension);
  trials.end = trials.first + static_cast<std::int64_t>(points.size() / d);
  auto work = empty_block();
  run::each_group(trials, judge::trials_at_once, [&](std::int64_t trial, std::int64_t count) {
    const auto before = static_cast<std::size_t>(trial - trials.first);
    judge_.judge({trials.replicate, trial}, points.subspan(before * d, static_cast<std::size_t>(count) * d), work);
  });
  work.end_block(trials.replicate);
  return work;
}

template <class Scalar>
void AccuracyCell<Scalar>::write(const judge::CellTally& tally, tables::Tables& tables,
                                 std::string_view failure) const {
  for (std::size_t m = 0; m < methods_.count(); ++m) {
    for (std::size_t k = 0; k < methods_.baseline_count(); ++k) {
      if (methods_.is_baseline(m, k)) continue;
      tables::Row row(methods_.is_stable(m, k) ? "accuracy.csv" : "unstable.csv");
      row.set_each(tables::cell_columns(), cell_fields(m)).set("trials", trials()).set("baseline", study_.baseline[k]);
      if (!methods_.judged(m, k)) {
        row.set("status", methods_.supported(methods_[m]) ? "baseline_degree_unsupported" : "degree_unsupported");
      } else if (!failure.empty()) {
        row.set("status", failure);
      } else {
        const judge::Judgement& judgement = tally.judgements[methods_.index(m, k)];
        row.set("status", "ok");
        set_statistics(row, {judgement, methods_.is_exact(k), trials(), tally.condition});
        if (judgement.worst && methods_.is_stable(m, k)) write_worst(m, *judgement.worst, tables);
      }
      tables.add(row);
    }
  }
  for (std::size_t m = 0; m < methods_.count(); ++m)
    if (methods_.supported(methods_[m]) && failure.empty()) write_reference(m, tally, tables);
  if (tally.audit.count() > 0)
    tables.add(tables::Row("audit.csv")
                   .set("study", study_.id)
                   .set("form", name(study_.form))
                   .set("tier", "long_double")
                   .set("significand_bits", std::numeric_limits<long double>::digits)
                   .set("dimension", cell_.dimension)
                   .set("degree", cell_.degree)
                   .set_each(tables::drawn_columns(), tables::drawn_fields(cell_))
                   .set("trials", tally.audit.count())
                   .set("mean_axis_error_ulp", tally.audit.mean())
                   .set("max_axis_error_ulp", tally.audit.max()));
}

/// Counts of a method's trials that do not depend on the baseline.
template <class Scalar>
void AccuracyCell<Scalar>::write_reference(std::size_t method, const judge::CellTally& tally,
                                           tables::Tables& tables) const {
  std::uint64_t own_kernel = 0;
  for (std::size_t k = 0; k < methods_.baseline_count(); ++k)
    if (methods_.judged(method, k))
      own_kernel = tally.judgements[methods_.index(method, k)].own_kernel;  // equal for every baseline
  tables::Row row("reference.csv");
  tables.add(row.set_each(tables::cell_columns(), cell_fields(method))
                 .set("trials", trials())
                 .set("tier", reference::name(tier_))
                 .set("escalated", tally.escalated)
                 .set("own_kernel", own_kernel));
}

template <class Scalar>
void AccuracyCell<Scalar>::write_worst(std::size_t method, const judge::Worst& worst, tables::Tables& tables) const {
  judge::TrialInputs<Scalar> inputs(study_.form, cell_);
  inputs.draw(sampler_, worst.trial);
  tables.add(tables::Row("worst.csv")
                 .set("worst_id", fmt::format("w{}", tables.table("worst.csv").row_count() + 1))
                 .set_each(tables::cell_columns(), cell_fields(method))
                 .set("trial", worst.trial)
                 .set("error", worst.error)
                 .set("error_u", worst.error_u)
                 .set_each(judge::input_columns(), judge::input_fields(inputs.values(), cell_.dimension)));
}

template <class Scalar>
void AccuracyCell<Scalar>::collect(const judge::CellTally& tally, std::vector<tables::Series>& series) const {
  for (std::size_t m = 0; m < methods_.count(); ++m)
    for (std::size_t k = 0; k < methods_.baseline_count(); ++k) {
      if (!methods_.judged(m, k)) continue;
      tables::Series one{.study = study_.id,
                         .form = std::string(name(study_.form)),
                         .method = std::string(methods_.info(m).id),
                         .statistic = "mean_error",
                         .degree = std::to_string(cell_.degree),
                         .coordinate_range = cell_.coordinate_range,
                         .t_interval = cell_.t_interval,
                         .generator = cell_.generator,
                         .baseline = study_.baseline[k],
                         .mode = "",
                         .values = over_replicates(tally, methods_.index(m, k), &judge::ReplicateStatistic::mean)};
      series.push_back(one);
      one.statistic = "max_error";
      one.values = over_replicates(tally, methods_.index(m, k), &judge::ReplicateStatistic::max);
      series.push_back(std::move(one));
    }
}

template <class Scalar>
void AccuracyCell<Scalar>::collect(const judge::CellTally& tally, std::vector<run::Violation>& violations) const {
  for (std::size_t m = 0; m < methods_.count(); ++m)
    for (std::size_t k = 0; k < methods_.baseline_count(); ++k) {
      const judge::Judgement& j = tally.judgements[methods_.index(m, k)];
      if (j.violations.count == 0) continue;
      violations.push_back({fmt::format("{}, method {}, first at trial {}",
                                        tables::describe(study_, cell_, judge::ScalarFacts<Scalar>::kind),
                                        methods_.info(m).id, j.violations.first),
                            j.violations.count});
    }
}

template class AccuracyCell<float>;
template class AccuracyCell<double>;

}  // namespace bezierbench::studies
