// SPDX-License-Identifier: MIT
// How unevenly points lie at equal steps of t, and how evenly at equal steps of the length: one curve, for a picture.
#pragma once

#include <cstdint>

#include "experiments/run/job.hpp"
#include "experiments/sample/cell.hpp"

namespace bezierbench::studies {

/// Adds to spacing.csv the curve of the study's trial 0 in `cell`: its outline, and 21 points from end to end, once at
/// equal steps of t (`parameter`) and once of the true length (`arc_length`). `share` is the length up to a point over
/// that of the curve, `gap` the length from the point before to it over the mean of these; neither is there for the
/// outline, nor for a curve that is a point. Coordinates are exact values, rounded once.
void add_spacing(tables::Tables& tables, const suite::Study& study, const sample::Cell& cell, std::uint64_t seed);

}  // namespace bezierbench::studies
