// SPDX-License-Identifier: MIT
// Every printed cell of a source report beside the same number computed here, with a verdict.
#pragma once

#include <span>

#include "experiments/tables/tables.hpp"

namespace bezierbench::tables {

/// Appends to `scorecard.csv` and `scorecard_timing.csv` one row per printed cell of the tables that these studies
/// reproduce. A study reproduces table X of its `published` file when its id is X or starts with "X-"; the first entry
/// of its `generator` and of its `baseline` are the report's own.
void write_scorecards(std::span<const suite::Study> studies, std::span<const Series> series, Tables& tables);

}  // namespace bezierbench::tables
