// SPDX-License-Identifier: MIT What the curves of a set are like: by form, dimension and degree, how large they are,
// how far from the origin, and how many are degenerate.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/curves/curve_set.hpp"

namespace bezierbench::metric {

/// Quantiles of a quantity over the curves of a group; by nearest rank, all NaN where no curve has the quantity.
struct CurveQuantiles {
  double median;
  double p99;
  double largest;
};

/// The curves of one form, dimension and degree. All quantities are those of the coefficients; what follows `high` is
/// that of control points, so it is empty (0 and NaN) for the power form.
struct CurveGroup {
  Form form;
  int dimension;
  int degree;
  std::size_t curves = 0;
  double low = 0;  ///< the smallest and the largest coordinate
  double high = 0;
  CurveQuantiles size{};      ///< the largest extent of the control points along an axis
  CurveQuantiles distance{};  ///< the largest magnitude of a coordinate over the size; of curves that are not a point
  std::size_t points = 0;     ///< all control points are one
  std::size_t coincident_ends = 0;        ///< the first control point is the last; of curves that are not a point
  std::size_t coincident_neighbours = 0;  ///< two consecutive control points are one; of curves that are not a point
  std::size_t collinear =
      0;  ///< degree 2 and more, no point: control points within 1e-12 of the size of a straight line
  std::size_t monotone = 0;  ///< no coordinate of the control points turns back; of curves that are not a point
};

/// The groups of a set, the most curves first; of equally many the lower degree.
std::vector<CurveGroup> curve_statistics(const curves::CurveSet& set);

}  // namespace bezierbench::metric
