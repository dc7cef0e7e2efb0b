// SPDX-License-Identifier: MIT
// A control polygon under repeated halving, with a running bound of the rounding errors that halving has added.
#pragma once

#include "core/project/polygon.hpp"

namespace bezierbench {

template <int Dimension, int Points = dynamic>
struct HalvedPolygon {
  Polygon<Dimension, Points> b;
  double largest;  ///< the largest magnitude of a coordinate
  double error;    ///< bound of the error of every coordinate

  /// Takes points that were rounded once.
  explicit HalvedPolygon(const Polygon<Dimension, Points>& rounded)
      : b(rounded), largest(largest_coordinate<Dimension>(b)), error(0x1p-53 * largest) {}
  HalvedPolygon(Polygon<Dimension, Points> half, double its_error)
      : b(std::move(half)), largest(largest_coordinate<Dimension>(b)), error(its_error) {}
};

template <int Dimension, int Points>
std::pair<HalvedPolygon<Dimension, Points>, HalvedPolygon<Dimension, Points>> halves(
    const HalvedPolygon<Dimension, Points>& polygon) {
  const double error = polygon.error + 0x1p-53 * static_cast<double>(polygon.b.cols()) * polygon.largest;
  auto [left, right] = halves<Dimension>(polygon.b);
  return {{std::move(left), error}, {std::move(right), error}};
}

}  // namespace bezierbench
