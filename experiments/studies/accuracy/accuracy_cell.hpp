// SPDX-License-Identifier: MIT
// One cell of an accuracy study in one scalar type: judges blocks of trials on any thread, and writes rows.
#pragma once

#include <memory>

#include "experiments/judge/cell_tally.hpp"
#include "experiments/run/job.hpp"
#include "experiments/sample/cell.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::studies {

class AccuracyCell {
 public:
  AccuracyCell() = default;
  AccuracyCell(const AccuracyCell&) = delete;
  AccuracyCell& operator=(const AccuracyCell&) = delete;
  AccuracyCell(AccuracyCell&&) = delete;
  AccuracyCell& operator=(AccuracyCell&&) = delete;
  virtual ~AccuracyCell() = default;

  [[nodiscard]] virtual std::size_t blocks() const = 0;
  [[nodiscard]] virtual judge::CellTally run_block(std::size_t block) const = 0;
  /// As of a job: of one block.
  [[nodiscard]] virtual double cost() const = 0;
  [[nodiscard]] virtual run::Extent extent() const = 0;

  /// `tally` is of all blocks.
  virtual void write(const judge::CellTally& tally, tables::Tables& tables) const = 0;
  virtual void collect(const judge::CellTally& tally, std::vector<tables::Series>& series) const = 0;
  virtual void collect(const judge::CellTally& tally, std::vector<run::Violation>& violations) const = 0;
};

/// `study` must outlive the cell. Throws Failure(usage) for methods and baselines that do not take its curves.
std::unique_ptr<AccuracyCell> accuracy_cell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell,
                                            suite::ScalarKind scalar, reference::Tier tier);

}  // namespace bezierbench::studies
