// SPDX-License-Identifier: MIT
#include "experiments/studies/accuracy/accuracy_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/judge/group_judge.hpp"
#include "experiments/judge/input_fields.hpp"
#include "experiments/judge/method_choice.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/judge/trial_inputs.hpp"
#include "experiments/number/number.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/accuracy/accuracy_row.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::int64_t block_trials = 1024;

template <class Scalar>
class ScalarCell final : public AccuracyCell {
 public:
  ScalarCell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell, reference::Tier tier)
      : study_(study),
        cell_(cell),
        tier_(tier),
        sampler_(seed, study.id, cell),
        methods_(study, cell),
        judge_(study_, cell_, sampler_, methods_, tier) {}

  [[nodiscard]] std::int64_t blocks_per_replicate() const { return (study_.trials - 1) / block_trials + 1; }
  [[nodiscard]] std::size_t blocks() const override {
    return static_cast<std::size_t>(blocks_per_replicate() * study_.replicates);
  }
  [[nodiscard]] double cost() const override {
    const double n = cell_.degree + 1.0;
    return static_cast<double>(std::min(study_.trials, block_trials)) *
           (200 + n * 150 + n * n * 2 * static_cast<double>(methods_.count()));
  }
  [[nodiscard]] run::Extent extent() const override {
    const auto trials = static_cast<std::uint64_t>(study_.trials * study_.replicates);
    const auto rows = methods_.judgement_count();
    return {1, 2 * rows, trials * methods_.count(),
            rows * judge::bytes_of_input(cell_)};  // of accuracy.csv and worst.csv
  }

  [[nodiscard]] judge::CellTally run_block(std::size_t block) const override {
    const auto replicate = static_cast<std::int64_t>(block) / blocks_per_replicate();
    const auto part = static_cast<std::int64_t>(block) % blocks_per_replicate();
    const auto first = part * block_trials;
    const auto last = std::min(study_.trials, first + block_trials);
    judge::CellTally work;
    work.blocks_per_replicate = blocks_per_replicate();
    work.judgements.resize(methods_.judgement_count());
    constexpr auto together = static_cast<std::int64_t>(judge::trials_at_once);
    for (auto trial = first; trial < last && !run::interrupted(); trial += together)
      judge_.judge({replicate, trial}, std::min(together, last - trial), trial == first, work);
    work.end_block(replicate);
    return work;
  }

  void write(const judge::CellTally& tally, tables::Tables& tables) const override;
  void collect(const judge::CellTally& tally, std::vector<tables::Series>& series) const override;
  void collect(const judge::CellTally& tally, std::vector<run::Violation>& violations) const override;

 private:
  void write_worst(std::size_t method, const judge::Worst& worst, tables::Tables& tables) const;
  void write_reference(std::size_t method, const judge::CellTally& tally, tables::Tables& tables) const;

  const suite::Study& study_;
  sample::Cell cell_;
  reference::Tier tier_;
  sample::Sampler sampler_;
  judge::JudgedMethods<Scalar> methods_;
  judge::GroupJudge<Scalar> judge_;
};

std::vector<std::string> reference_columns() {
  std::vector<std::string> columns = tables::cell_columns();
  columns.insert(columns.end(), {"tier", "trials", "escalated", "own_kernel", "unbounded_trials"});
  return columns;
}

const std::vector<std::string> audit_columns{
    "study", "curve",     "tier",   "significand_bits",    "dimension",         "degree", "coordinate_range", "t_min",
    "t_max", "generator", "trials", "mean_axis_error_ulp", "max_axis_error_ulp"};

std::vector<std::string> worst_columns() {
  std::vector<std::string> columns{"worst_id"};
  columns.insert(columns.end(), tables::cell_columns().begin(), tables::cell_columns().end());
  columns.insert(columns.end(), {"trial", "error", "error_u"});
  columns.insert(columns.end(), judge::input_columns().begin(), judge::input_columns().end());
  return columns;
}

template <class Scalar>
void ScalarCell<Scalar>::write(const judge::CellTally& tally, tables::Tables& tables) const {
  const auto number = [](double value) { return number::decimal(value); };
  for (std::size_t m = 0; m < methods_.count(); ++m) {
    for (std::size_t k = 0; k < methods_.baseline_count(); ++k) {
      if (methods_.is_baseline(m, k)) continue;
      auto row = tables::cell_fields(study_, cell_, methods_.info(m).id, judge::ScalarFacts<Scalar>::kind);
      row.push_back(std::to_string(study_.trials * study_.replicates));
      row.push_back(study_.baseline[k]);
      if (!methods_.judged(m, k)) {
        row.emplace_back(methods_.supported(methods_[m]) ? "baseline_degree_unsupported" : "degree_unsupported");
        row.resize(accuracy_columns().size());
      } else {
        const judge::Judgement& judgement = tally.judgements[methods_.index(m, k)];
        row.emplace_back("ok");
        for (auto& field : accuracy_statistics(judgement, methods_.is_exact(k), tally.condition))
          row.push_back(std::move(field));
        if (judgement.worst && methods_.is_stable(m, k)) write_worst(m, *judgement.worst, tables);
      }
      tables.table(methods_.is_stable(m, k) ? "accuracy.csv" : "unstable.csv", accuracy_columns())
          .add_row(std::move(row));
    }
  }
  for (std::size_t m = 0; m < methods_.count(); ++m)
    if (methods_.supported(methods_[m])) write_reference(m, tally, tables);
  if (tally.audit.count() > 0)
    tables.table("audit.csv", audit_columns)
        .add_row({study_.id, std::string(suite::name(study_.curve)), "long_double",
                  std::to_string(std::numeric_limits<long double>::digits), std::to_string(cell_.dimension),
                  std::to_string(cell_.degree), number(cell_.coordinate_range), number(cell_.t_interval.min),
                  number(cell_.t_interval.max), cell_.generator, std::to_string(tally.audit.count()),
                  number(tally.audit.mean()), number(tally.audit.max())});
}

/// How the trials of a method were judged, whatever it was compared with.
template <class Scalar>
void ScalarCell<Scalar>::write_reference(std::size_t method, const judge::CellTally& tally,
                                         tables::Tables& tables) const {
  const std::int64_t trials = study_.trials * study_.replicates;
  std::uint64_t own_kernel = 0;
  std::string unbounded;
  for (std::size_t k = 0; k < methods_.baseline_count(); ++k) {
    if (!methods_.judged(method, k)) continue;
    const judge::Judgement& judgement = tally.judgements[methods_.index(method, k)];
    own_kernel = judgement.own_kernel;  // the same of every baseline
    if (methods_.is_exact(k)) unbounded = std::to_string(trials - static_cast<std::int64_t>(judgement.bounded));
  }
  auto row = tables::cell_fields(study_, cell_, methods_.info(method).id, judge::ScalarFacts<Scalar>::kind);
  row.insert(row.end(), {std::string(reference::name(tier_)), std::to_string(trials), std::to_string(tally.escalated),
                         std::to_string(own_kernel), unbounded});
  tables.table("reference.csv", reference_columns()).add_row(std::move(row));
}

template <class Scalar>
void ScalarCell<Scalar>::write_worst(std::size_t method, const judge::Worst& worst, tables::Tables& tables) const {
  auto& table = tables.table("worst.csv", worst_columns());
  judge::TrialInputs<Scalar> inputs(study_.curve, cell_);
  inputs.draw(sampler_, worst.trial);
  std::vector<std::string> row{fmt::format("w{}", table.row_count() + 1)};
  for (auto& field : tables::cell_fields(study_, cell_, methods_.info(method).id, judge::ScalarFacts<Scalar>::kind))
    row.push_back(std::move(field));
  row.push_back(std::to_string(worst.trial));
  row.push_back(number::decimal(worst.error));
  row.push_back(number::decimal(worst.error_u));
  for (auto& field : judge::input_fields(inputs.values(), cell_.dimension)) row.push_back(std::move(field));
  table.add_row(std::move(row));
}

/// One statistic of a judgement over the replicates that have it.
std::vector<double> over_replicates(const judge::CellTally& tally, std::size_t judgement,
                                    double judge::ReplicateStatistic::*which) {
  std::vector<double> values;
  for (const auto& [replicate, statistics] : tally.closed)
    if (const double value = statistics.at(judgement).*which; !std::isnan(value)) values.push_back(value);
  return values;
}

template <class Scalar>
void ScalarCell<Scalar>::collect(const judge::CellTally& tally, std::vector<tables::Series>& series) const {
  for (std::size_t m = 0; m < methods_.count(); ++m)
    for (std::size_t k = 0; k < methods_.baseline_count(); ++k) {
      if (!methods_.judged(m, k)) continue;
      tables::Series one{.study = study_.id,
                         .curve = std::string(suite::name(study_.curve)),
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
void ScalarCell<Scalar>::collect(const judge::CellTally& tally, std::vector<run::Violation>& violations) const {
  for (std::size_t m = 0; m < methods_.count(); ++m)
    for (std::size_t k = 0; k < methods_.baseline_count(); ++k) {
      const judge::Judgement& j = tally.judgements[methods_.index(m, k)];
      if (j.violations == 0) continue;
      violations.push_back({fmt::format("{}, method {}, first at trial {}",
                                        tables::describe(study_, cell_, judge::ScalarFacts<Scalar>::kind),
                                        methods_.info(m).id, j.first_violation),
                            j.violations});
    }
}

}  // namespace

std::unique_ptr<AccuracyCell> accuracy_cell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell,
                                            suite::ScalarKind scalar, reference::Tier tier) {
  if (scalar == suite::ScalarKind::float32) return std::make_unique<ScalarCell<float>>(study, seed, cell, tier);
  return std::make_unique<ScalarCell<double>>(study, seed, cell, tier);
}

}  // namespace bezierbench::studies
