// SPDX-License-Identifier: MIT
// Points of one curve at equal steps of t and at equal steps of the length, for a picture of their spacing.
#pragma once

#include <cstdint>

#include "experiments/run/job.hpp"
#include "experiments/sample/cell.hpp"

namespace bezierbench::studies {

/// Adds the curve of the study's trial 0 in `cell` to spacing.csv: its outline, and 21 points from end to end, once at
/// equal steps of t (`parameter`) and once at equal steps of the true length (`arc_length`). `share` is the length up
/// to a point over the length of the curve; `gap` is the length from the point before, over the mean gap. Both are
/// empty for the outline and for a curve that is a point. Coordinates are exact values, rounded once.
void add_spacing(tables::Tables& tables, const suite::Study& study, const sample::Cell& cell, std::uint64_t seed);

}  // namespace bezierbench::studies
