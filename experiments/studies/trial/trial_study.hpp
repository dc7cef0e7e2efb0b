// SPDX-License-Identifier: MIT
// The study of the errors of a companion problem, common to all kinds. Every trial of every part is drawn. Every method
// solves it at every tolerance, its answer is judged and tallied, and the table has a row for each method. The problem
// defines everything else (problem.hpp of each kind).
//
// Accuracy and conversion cut their trials and loop over them by the same run::TrialBlocks, but are jobs of their own.
// An accuracy study draws and evaluates trials in groups, measures every answer from several baselines, and writes five
// tables and series of replicates; a conversion study judges chains of methods that its suite makes up, which have no
// MethodInfo and no times. As problems they would have another version of nearly every member of TrialJob.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/failure.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/run/blocks/trial_blocks.hpp"
#include "experiments/run/job.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/length/true_length.hpp"

namespace bezierbench::studies {

/// A problem whose errors are studied.
///
/// `judge` adds the errors of an answer to the tallies of its row, which metric::merge_fields merges. It takes the
/// trial as not const, since costly parts of the truth may be computed when a trial is first judged. `table` is NAME in
/// NAME.csv and, for methods that are not bit-stable, in NAME_unstable.csv. `case_columns` and `columns` make the
/// fields of a row; tables.schema.json declares the columns and their order. `trial_nanoseconds` estimates the cost of
/// a trial with `methods` methods; see run::Job::cost.
template <class P>
concept StudiedProblem = judge::TrialProblem<P> &&
    requires(const P& trials, const typename P::Kernel& method, typename P::Drawn& drawn,
             const typename P::Answer& answer, double tolerance, std::uint64_t number, typename P::Errors& errors,
             const judge::TrialPart& part, std::size_t methods, const typename P::Row& row) {
  trials.judge(method, drawn, tolerance, answer, number, errors);
  metric::merge_fields(errors, errors);
  requires std::same_as<const std::int64_t, decltype(P::block_trials)>;
  { P::trial_nanoseconds(part, methods) } -> std::same_as<double>;
  std::string_view(P::table);
  { P::case_columns[0].field(row.values) } -> std::same_as<std::string>;
  { P::columns[0].field(row) } -> std::same_as<tables::Field>;
  { P::failures[0].trials(row) } -> std::same_as<const metric::TrialCount&>;
};

/// The errors of a part, row by row.
template <class Errors>
struct TrialErrors {
  std::vector<Errors> rows;
  std::uint8_t status = 0;  ///< of an external method: the worst external::Status of its blocks

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.rows, self.status);
  }
  void merge(const TrialErrors& other) {
    metric::merge_fields(rows, other.rows);
    status = std::max(status, other.status);
  }
};

template <StudiedProblem P>
class TrialJob : public run::JobOf<TrialErrors<typename P::Errors>> {
 public:
  TrialJob(const suite::Study& study, const run::JobContext& context) : TrialJob(study, context, P::block_trials) {
    for (Part& part : parts_) part.methods = judge::chosen_trial_kernels<P>(study_, part.part.cell.dimension);
    judge::require_form(study_, std::ranges::any_of(parts_, [](const Part& part) { return !part.methods.empty(); }));
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return blocks_.count(); }
  [[nodiscard]] double cost(std::size_t part) const override {
    return static_cast<double>(blocks_.full()) * P::trial_nanoseconds(parts_[part].part, parts_[part].methods.size());
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (const Part& part : parts_) sum += {1, rows_of(part), static_cast<std::uint64_t>(trials()) * rows_of(part)};
    return sum;
  }
  void write(tables::Tables& tables) const override {
    each_row([&](const Row& row, std::size_t part) { tables.add(row_of(row, failure(part))); });
    if constexpr (requires { P::write_example(tables, study_, context_.seed); })
      P::write_example(tables, study_, context_.seed);
  }
  [[nodiscard]] std::vector<run::Violation> violations() const override {
    std::vector<run::Violation> all;
    each_row([&](const Row& row, std::size_t /*part*/) {
      for (const auto& failure : P::failures)
        if (const metric::TrialCount& failed = failure.trials(row); failed.count > 0)
          all.push_back({where(row, failure.what, failed.first), failed.count, failure.broken});
    });
    return all;
  }

 protected:
  using Row = typename P::Row;
  using Tally = TrialErrors<typename P::Errors>;

  struct Part {
    judge::TrialPart part;
    std::vector<const typename P::Kernel*> methods;
  };

  /// Of parts without methods.
  TrialJob(const suite::Study& study, const run::JobContext& context, std::int64_t block_trials)
      : study_(study), context_(context), blocks_(trials(), 1, block_trials) {
    judge::check_inputs(study_);
    tolerances_ = judge::tolerances_of(study_, P::axes);
    for (auto& part : judge::parts_of(study_, P::axes)) parts_.push_back({std::move(part), {}});
  }

  [[nodiscard]] Tally work(std::size_t block) const override {
    const Part& part = parts_[this->part_of(block)];
    Tally tally;
    tally.rows.resize(rows_of(part));
    if (std::ranges::none_of(part.methods, [&](const auto* method) { return takes(*method, part); })) return tally;
    const P problem = problem_of(part);
    typename P::Drawn drawn;
    run::each_trial(blocks_[block % blocks_per_part()], [&](std::int64_t trial) {
      judge(problem, part, static_cast<std::uint64_t>(trial), drawn, tally.rows);
    });
    return tally;
  }
  /// What the rows of this part have as their status in place of numbers; empty where they have numbers.
  [[nodiscard]] virtual std::string_view failure(std::size_t /*part*/) const { return {}; }

  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }
  [[nodiscard]] std::size_t rows_of(const Part& part) const { return part.methods.size() * tolerances_.size(); }
  /// A problem whose truth has two tiers gets the one to use.
  [[nodiscard]] P problem_of(const Part& part) const {
    if constexpr (std::constructible_from<P, const suite::Study&, std::uint64_t, const judge::TrialPart&,
                                          reference::Tier>)
      return P(study_, context_.seed, part.part, context_.tier);
    else
      return P(study_, context_.seed, part.part);
  }
  [[nodiscard]] static bool takes(const typename P::Kernel& method, const Part& part) {
    return judge::takes<P>(*method.info, part.part.cell);
  }
  /// Calls `use`, which draws the trial of this number.
  template <class Use>
  void with_truth(const Part& part, std::uint64_t number, const Use& use) const {
    try {
      use();
    } catch (const reference::NotCertain& error) {
      throw Failure(Exit::usage, fmt::format("{}, trial {}: {}; leave this cell out of the suite",
                                             describe(part.part.cell), number, error.what()));
    }
  }

  suite::Study study_;
  run::JobContext context_;
  run::TrialBlocks blocks_;
  std::vector<double> tolerances_;
  std::vector<Part> parts_;

 private:
  [[nodiscard]] std::string describe(const sample::Cell& cell) const {
    return tables::describe(study_, cell, suite::ScalarKind::float64);
  }

  /// Judges one trial by every method at every tolerance.
  void judge(const P& problem, const Part& part, std::uint64_t number, typename P::Drawn& drawn,
             std::vector<typename P::Errors>& rows) const {
    with_truth(part, number, [&] {
      problem.draw(number, drawn);
      std::size_t k = 0;
      for (const double tolerance : tolerances_)
        for (const auto* method : part.methods) {
          typename P::Errors& errors = rows[k++];
          if (!takes(*method, part)) continue;
          typename P::Answer answer{};
          problem.ask(*method, drawn, tolerance, answer);
          problem.judge(*method, drawn, tolerance, answer, number, errors);
        }
    });
  }

  /// Visits all rows with the number of their part: by part, then by tolerance, then by method in the order of the study.
  template <class Visit>
  void each_row(Visit&& visit) const {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const Part& part = parts_[p];
      std::size_t number = 0;
      for (const double tolerance : tolerances_)
        for (const auto* method : part.methods) {
          auto values = part.part.values;
          if (P::axes.tolerance) values.tolerance = tolerance;
          visit(Row{part.part.cell, values, *method, trials(), this->state(p).rows.at(number++)}, p);
        }
    }
  }

  [[nodiscard]] tables::Row row_of(const Row& row, std::string_view failure) const {
    const MethodInfo& info = *row.method.info;
    const bool taken = judge::takes<P>(info, row.cell);
    tables::Row written(fmt::format("{}{}.csv", P::table, info.bit_stable ? "" : "_unstable"));
    written.set_each(tables::cell_columns(), tables::cell_fields(study_, row.cell, info.id, suite::ScalarKind::float64))
        .set("trials", row.trials)
        .set("status", !taken            ? "degree_unsupported"
                       : failure.empty() ? "ok"
                                         : failure);
    for (const judge::CaseColumn& column : P::case_columns) written.set(column.name, column.field(row.values));
    if (taken && failure.empty())
      for (const auto& column : P::columns) written.set(column.name, column.field(row));
    return written;
  }

  [[nodiscard]] std::string where(const Row& row, std::string_view what, std::uint64_t first) const {
    std::string text = describe(row.cell);
    for (const judge::CaseColumn& column : P::case_columns)
      text += fmt::format(", {} {}", column.name, column.field(row.values));
    text += fmt::format(", method {}", row.method.info->id);
    if (!what.empty()) text += fmt::format(", {}", what);
    return text + fmt::format(", first at trial {}", first);
  }
};

/// The job of the study. Throws Failure(usage) for inputs that the problem does not take, and where no method takes
/// curves of this form.
template <StudiedProblem P>
std::unique_ptr<run::Job> trial_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<TrialJob<P>>(study, context);
}

}  // namespace bezierbench::studies
