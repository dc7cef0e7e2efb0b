// SPDX-License-Identifier: MIT
// A control polygon under repeated halving, with a running bound of the rounding errors that halving has added.
#pragma once

#include "core/project/polygon.hpp"

namespace bezierbench {

template <int Dimension, int Points = dynamic>
struct HalvedPolygon {
  Polygon<Dimension, Points> b;
  double largest = 0;  ///< the largest magnitude of a coordinate
  double error = 0;    ///< bound of the error of every coordinate

  HalvedPolygon() = default;
  /// Takes points that were rounded once.
  explicit HalvedPolygon(const Polygon<Dimension, Points>& rounded)
      : b(rounded), largest(largest_coordinate<Dimension>(b)), error(0x1p-53 * largest) {}
};

/// Sets the polygons over [0, 1/2] and [1/2, 1]. gnu::flatten: points stay in registers until their magnitudes are
/// compared.
template <int Dimension, int Points>
[[gnu::flatten]] void halve(const HalvedPolygon<Dimension, Points>& polygon, HalvedPolygon<Dimension, Points>& left,
                            HalvedPolygon<Dimension, Points>& right) {
  halve<Dimension>(polygon.b, left.b, right.b);
  left.largest = largest_coordinate<Dimension>(left.b);
  right.largest = largest_coordinate<Dimension>(right.b);
  left.error = right.error = polygon.error + 0x1p-53 * static_cast<double>(polygon.b.cols()) * polygon.largest;
}

}  // namespace bezierbench
