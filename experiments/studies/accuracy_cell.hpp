// SPDX-License-Identifier: MIT
// One cell of an accuracy study in one scalar type: judges blocks of trials on any thread, then writes its rows.
#pragma once

#include <memory>

#include "experiments/sample/cell.hpp"
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
  virtual void run_block(std::size_t block) = 0;
  /// Relative cost of one block.
  [[nodiscard]] virtual double cost() const = 0;
  [[nodiscard]] virtual Extent extent() const = 0;

  virtual void write(Tables& tables) const = 0;
  virtual void collect(std::vector<Series>& series) const = 0;
  virtual void collect(std::vector<Violation>& violations) const = 0;
};

/// `study` must outlive the cell. Throws Failure(usage) for methods and baselines that do not take its curves.
std::unique_ptr<AccuracyCell> accuracy_cell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell,
                                            suite::ScalarKind scalar, reference::Tier tier);

}  // namespace bezierbench::studies
