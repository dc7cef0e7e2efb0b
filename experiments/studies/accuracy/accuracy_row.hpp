// SPDX-License-Identifier: MIT
// The columns of accuracy.csv after those of the cell.
#pragma once

#include <cstdint>

#include "experiments/judge/judgement.hpp"
#include "experiments/tables/tables.hpp"

namespace bezierbench::studies {

/// A method's trials in one cell against one baseline, as they were judged.
struct Statistics {
  const judge::Judgement& judgement;
  bool exact;                      ///< against the exact reference
  std::int64_t trials;             ///< of the cell
  const metric::Tally& condition;  ///< likewise

  [[nodiscard]] bool bounded() const { return judgement.bounded > 0; }
};

/// Sets the statistics of a row of accuracy.csv or unstable.csv: what stands after `status`. What is measured against
/// the exact reference only is empty for other baselines.
void set_statistics(tables::Row& row, const Statistics& statistics);

}  // namespace bezierbench::studies
