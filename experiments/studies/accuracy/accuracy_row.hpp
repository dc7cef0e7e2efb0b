// SPDX-License-Identifier: MIT
// The columns of accuracy.csv after those of the cell.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/judge/judgement.hpp"

namespace bezierbench::studies {

/// All columns of accuracy.csv (and of unstable.csv): the cell's, then trials, baseline, status, then the statistics.
const std::vector<std::string>& accuracy_columns();

/// The fields of the statistics' columns. What is measured against the exact reference only stays empty where `exact`
/// is false; `condition` is of the trials of the cell.
std::vector<std::string> accuracy_statistics(const judge::Judgement& judgement, bool exact,
                                             const metric::Tally& condition);

}  // namespace bezierbench::studies
