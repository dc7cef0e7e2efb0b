// SPDX-License-Identifier: MIT
// The concept of a method for the points of a curve on a uniform grid: `info`, a function for the work per curve and
// grid, and one that runs through the grid.
#pragma once

#include <concepts>

#include "core/bound/grid_bound.hpp"
#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// The grid has the parameters t_k = k/m for k = 0..m, where m is a power of two up to 2^20, so that each is a number.
inline constexpr int max_grid_steps = 1 << 20;

constexpr bool is_grid(int steps) { return steps >= 1 && steps <= max_grid_steps && (steps & (steps - 1)) == 0; }

/// `prepare(curve, steps)` does all work that does not grow with the number of points. `run(prepared, take)` calls
/// take(k, point) for k = 0..steps in this order, and neither allocates, prints nor throws.
template <class M>
concept GridMethod = requires(const Curve<M::info.form, double, 2>& curve, int steps,
                              void (*take)(int, const Point<double, 2>&)) {
  requires M::info.problem == Problem::grid;
  { M::bound } -> std::convertible_to<GridBound>;
  M::run(M::prepare(curve, steps), take);
};

}  // namespace bezierbench
