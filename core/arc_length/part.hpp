// SPDX-License-Identifier: MIT
// The part of a curve in Bernstein form over an interval of its parameter.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/curve.hpp"
#include "core/powers.hpp"

namespace bezierbench {

/// Replaces h by its control points over [from, to], by two runs of de Casteljau's algorithm: a cut at `to`, then one
/// at from / to. Exact except for roundings, which grow outside [0, 1]. `to` may be 0 only if `from` is 0.
template <int Dimension>
void restrict_to(Curve<Form::bernstein, double, Dimension>& h, double from, double to) {
  const int m = h.degree();
  const auto cut = [&](double t, bool keep_left) {
    auto kept = h;
    for (int level = 0; level <= m; ++level) {
      for (int axis = 0; axis < Dimension; ++axis) {
        const int i = keep_left ? level : m - level;
        kept(axis, i) = h(axis, keep_left ? 0 : i);
      }
      for (int i = 0; i < m - level; ++i)
        for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = (1 - t) * h(axis, i) + t * h(axis, i + 1);
    }
    h = kept;
  };
  if (to != 1) cut(to, true);
  if (from != 0) cut(from / to, false);
}

/// A bound of the error of the length of `part` due to the roundings of restrict_to, which made it from h. The length
/// is the mean of the control vectors times the width; each of them is off by 6 (m + 1) u of the largest of h. The
/// beginning, where the speed is that of the first vector, is off by u from the quotient from / to. 0 for the whole
/// curve. Next to a cusp this error is much larger than the effect of roundings in the part's own control vectors. The
/// bound is divided by 2^exponent. With the exponent of the width, no product underflows.
template <int Dimension>
double rounding_of_part(const Curve<Form::bernstein, double, Dimension>& h,
                        const Curve<Form::bernstein, double, Dimension>& part, double from, double to,
                        int exponent = 0) {
  if (from == 0 && to == 1) return 0;
  constexpr double u = 0x1p-53;
  double largest = 0;
  double first = 0;
  for (int axis = 0; axis < Dimension; ++axis) {
    first += std::abs(part(axis, 0));
    for (int i = 0; i <= h.degree(); ++i) largest = std::max(largest, std::abs(h(axis, i)));
  }
  const double width = times_power_of_two(std::abs(to - from), -exponent);
  const double beginning = from > 0 ? times_power_of_two(2 * first, -exponent) : 0;
  return u * (6 * (h.degree() + 1) * Dimension * largest * width + beginning);
}

}  // namespace bezierbench
