// SPDX-License-Identifier: MIT
// What methods make of a whole curve: derivatives, points of a grid, halves, boxes.
#include <algorithm>
#include <cmath>
#include <vector>

#include "bindings/c/curve.hpp"
#include "bindings/c/more_axes.hpp"
#include "core/bounds/kernel.hpp"
#include "core/derivative/kernel.hpp"
#include "core/grid/grid.hpp"
#include "core/grid/kernel.hpp"
#include "core/subdivide/kernel.hpp"
#include "reference/companion/exact_roots.hpp"

using namespace bezierbench;

int bb_derivative(const char* method, const bb_curve* curve, int order, const double* t, std::size_t count,
                  double* out) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(derivative_kernels(view.dimension), method, view);
    c::require(order >= 0, BB_ERROR_PARAMETER);
    const auto ts = c::parameters(*kernel.info, t, count);
    if (ts.empty()) return;
    c::require_pointers(out);
    for (const double at : ts) {
      kernel.derivative(view, order, at, out);
      out += view.dimension;
    }
  });
}

int bb_grid(const char* method, const bb_curve* curve, int steps, double* out) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(grid_kernels(view.dimension), method, view);
    c::require(is_grid(steps), BB_ERROR_COUNT);
    c::require_pointers(out);
    c::require(!reference::pole(view), BB_ERROR_NO_POINT);
    kernel.points(view, steps, out);
  });
}

int bb_split(const char* method, const bb_curve* curve, double t, const bb_half* left, const bb_half* right) {
  return c::guarded([&] {
    if (c::has_more_axes(curve)) {
      c::require_shape(c::max_dimension, curve->degree);
      c::require_pointers(left, right);
      c::require_pointers(left->points, right->points);
      const auto rows = static_cast<std::size_t>(curve->degree) + 1;
      std::vector<double> weights(2 * rows);
      const bool rational = curve->form == BB_RATIONAL;
      if (rational) c::require_pointers(left->weights, right->weights);
      std::vector<double> both(2 * rows * static_cast<std::size_t>(curve->dimension));
      c::by_axes(*curve, 2 * rows, both.data(), [&](const bb_curve& part, double* of_part) {
        const std::size_t half = rows * static_cast<std::size_t>(part.dimension);
        const bb_half first{of_part, weights.data()};
        const bb_half second{of_part + half, weights.data() + rows};
        return bb_split(method, &part, t, &first, &second);
      });
      if (rational) {
        std::copy_n(weights.data(), rows, left->weights);
        std::copy_n(weights.data() + rows, rows, right->weights);
      }
      const auto middle = both.begin() + static_cast<std::ptrdiff_t>(both.size() / 2);
      std::copy(both.begin(), middle, left->points);
      std::copy(middle, both.end(), right->points);
      return;
    }
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(split_kernels(view.dimension), method, view);
    (void)c::parameters(*kernel.info, &t, 1);
    const bool rational = view.form == Form::rational;
    c::require_pointers(left, right);
    for (const bb_half* half : {left, right}) {
      c::require_pointers(half->points);
      if (rational) c::require_pointers(half->weights);
    }
    const auto d = static_cast<std::size_t>(view.dimension);
    const auto columns = static_cast<std::size_t>(split_columns(view.form, view.dimension));
    const auto points = static_cast<std::size_t>(view.degree) + 1;
    std::vector<double> halves(2 * points * columns);
    kernel.split(view, t, halves.data(), halves.data() + points * columns);
    if (rational)
      for (std::size_t i = d; i < halves.size(); i += columns) c::require(halves[i] != 0, BB_ERROR_NO_POINT);
    const double* from = halves.data();
    for (const bb_half* half : {left, right})
      for (std::size_t i = 0; i < points; ++i, from += columns) {
        std::copy_n(from, d, half->points + i * d);
        if (rational) half->weights[i] = from[d];
      }
  });
}

int bb_box(const char* method, const bb_curve* curve, double* out) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& kernel = c::chosen(bounds_kernels(view.dimension), method, view);
    c::require_pointers(out);
    kernel.box(view, out);
  });
}
