// SPDX-License-Identifier: MIT
// Formula: the box of the control points of the 2^4 pieces that four halvings make. Their polygon converges by a factor
//   of four a halving.
// Bound: none. A midpoint rounds once, unless it underflows.
// Fails: the box is too large by about a 256th of what the box of the control points is, and may still be too small by
//   the roundings of midpoints.
#pragma once

#include <utility>

#include "core/bounds/extrema_parameters.hpp"

namespace bezierbench {

struct HalvedPolygonBox {
  static constexpr BoxPromises promises{.contains = false, .within_one_ulp = false};
  static constexpr MethodInfo info{.id = "halved_polygon_box",
                                   .label = "Box of the control points after four halvings",
                                   .problem = Problem::bounds,
                                   .flops = "15n(n+1)d",
                                   .cost_exponent = 2,
                                   .citation = "[Lane and Riesenfeld 1981]"};

  static Range range(const PolynomialAxis& axis) {
    Range range = range_of_ends(axis);
    std::vector<double> b(axis.data(), axis.data() + axis.degree() + 1);
    include(std::move(b), 4, range);
    return range;
  }

 private:
  static void include(std::vector<double> b, int halvings, Range& range) {
    if (halvings == 0) {
      for (const double x : b) range.include(x);
      return;
    }
    auto [left, right] = bernstein_halves(std::move(b));
    include(std::move(left), halvings - 1, range);
    include(std::move(right), halvings - 1, range);
  }
};

}  // namespace bezierbench
