// SPDX-License-Identifier: MIT
// One cell of an accuracy study in one scalar type: judges blocks of trials on any thread, and writes rows.
#pragma once

#include <memory>

#include "experiments/sample/cell.hpp"
#include "experiments/studies/cell_tally.hpp"
#include "experiments/studies/job.hpp"
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
  [[nodiscard]] virtual CellTally run_block(std::size_t block) const = 0;
  /// As of a job: of one block.
  [[nodiscard]] virtual double cost() const = 0;
  [[nodiscard]] virtual Extent extent() const = 0;

  /// `tally` is of all blocks.
  virtual void write(const CellTally& tally, Tables& tables) const = 0;
  virtual void collect(const CellTally& tally, std::vector<Series>& series) const = 0;
  virtual void collect(const CellTally& tally, std::vector<Violation>& violations) const = 0;
};

/// `study` must outlive the cell. Throws Failure(usage) for methods and baselines that do not take its curves.
std::unique_ptr<AccuracyCell> accuracy_cell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell,
                                            suite::ScalarKind scalar, reference::Tier tier);

}  // namespace bezierbench::studies
