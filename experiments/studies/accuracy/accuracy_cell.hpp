// SPDX-License-Identifier: MIT
// One cell of an accuracy study in one scalar type: judges blocks of trials on any thread, and writes rows.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/judge/cell_tally.hpp"
#include "experiments/judge/group_judge.hpp"
#include "experiments/judge/judged_methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/run/blocks/trial_blocks.hpp"
#include "experiments/run/job.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::studies {

// The columns of accuracy.csv after those of the cell.

/// A method's trials in one cell against one baseline, as they were judged.
struct Statistics {
  const judge::Judgement& judgement;
  bool exact;                      ///< against the exact reference
  std::int64_t trials;             ///< of the cell
  const metric::Tally& condition;  ///< likewise

  [[nodiscard]] bool bounded() const { return judgement.bounded > 0; }
};

/// Sets the statistics of a row of accuracy.csv or unstable.csv: those after `status`. What is measured against
/// the exact reference only is empty for other baselines.
void set_statistics(tables::Row& row, const Statistics& statistics);

template <class Scalar>
class AccuracyCell {
 public:
  /// `study` must outlive the cell. Throws Failure(usage) for methods and baselines that do not take its curves.
  AccuracyCell(const suite::Study& study, const run::JobContext& context, const sample::Cell& cell);
  /// For one method only, whose points are computed elsewhere; `method` describes it and must outlive the cell.
  AccuracyCell(const suite::Study& study, const run::JobContext& context, const sample::Cell& cell,
               const Kernel<Scalar>& method);
  AccuracyCell(const AccuracyCell&) = delete;
  AccuracyCell& operator=(const AccuracyCell&) = delete;

  [[nodiscard]] std::size_t blocks() const { return blocks_.count(); }
  [[nodiscard]] judge::CellTally run_block(std::size_t block) const;
  /// The same for given points of the first trials of the block, point by point; the others are not judged.
  [[nodiscard]] judge::CellTally judge_block(std::size_t block, std::span<const double> points) const;
  /// Trial numbers of a block, counted on through the replicates: the first, and one past the last.
  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> trials_of(std::size_t block) const;
  [[nodiscard]] const sample::Sampler& sampler() const { return sampler_; }
  [[nodiscard]] const sample::Cell& cell() const { return cell_; }
  /// As of a job: of one block.
  [[nodiscard]] double cost() const;
  [[nodiscard]] run::Extent extent() const;

  /// `tally` is of all blocks. With `failure`, the status of methods that gave no answer, rows have no numbers.
  void write(const judge::CellTally& tally, tables::Tables& tables, std::string_view failure = {}) const;
  void collect(const judge::CellTally& tally, std::vector<tables::Series>& series) const;
  void collect(const judge::CellTally& tally, std::vector<run::Violation>& violations) const;

 private:
  [[nodiscard]] judge::CellTally empty_block() const;
  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }
  [[nodiscard]] std::vector<tables::Field> cell_fields(std::size_t method) const {
    return tables::cell_fields(study_, cell_, methods_.info(method).id, judge::ScalarFacts<Scalar>::kind);
  }
  void write_worst(std::size_t method, const judge::Worst& worst, tables::Tables& tables) const;
  void write_reference(std::size_t method, const judge::CellTally& tally, tables::Tables& tables) const;

  const suite::Study& study_;
  sample::Cell cell_;
  run::TrialBlocks blocks_;
  reference::Tier tier_;
  sample::Sampler sampler_;
  judge::JudgedMethods<Scalar> methods_;
  judge::GroupJudge<Scalar> judge_;  ///< refers to the members before it
};

}  // namespace bezierbench::studies
