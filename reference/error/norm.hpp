// SPDX-License-Identifier: MIT
// The Euclidean norm of a point, on a double or on many lanes with a point in each; every lane has the bits of the
// double.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/vector/lane_choice.hpp"

namespace bezierbench::reference {

[[nodiscard]] inline bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// The larger of two numbers.
template <class Real>
Real larger(const Real& a, const Real& b) {
  return select(a < b, b, a);
}

/// The norm of coordinate(0), ..., coordinate(dimension - 1). Squares neither overflow nor vanish: coordinates are
/// scaled by a power of two where they would.
template <class Real, class Coordinate>
Real norm(int dimension, const Coordinate& coordinate) {
  using std::abs;
  using std::sqrt;
  Real largest(0);
  for (int axis = 0; axis < dimension; ++axis) largest = larger<Real>(largest, abs(coordinate(axis)));
  const Real up(0x1p+600);
  const Real down(0x1p-600);
  const auto is_huge = Real(0x1p+500) < largest;
  const auto is_tiny = largest < Real(0x1p-400);
  const Real scale = select(is_huge, down, select(is_tiny, up, Real(1)));
  const Real unscale = select(is_huge, up, select(is_tiny, down, Real(1)));
  Real sum(0);
  for (int axis = 0; axis < dimension; ++axis) {
    const Real scaled = coordinate(axis) * scale;
    sum += scaled * scaled;
  }
  return sqrt(sum) * unscale;
}

}  // namespace bezierbench::reference
