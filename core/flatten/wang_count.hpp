// SPDX-License-Identifier: MIT
// Formula: m = ceil(sqrt(n (n-1) max |b_(i+2) - 2 b_(i+1) + b_i| / (8 E))) chords between the points at k/m.
// Source: [Sederberg 2012], section 10.6.
// Bound: a piece over [a, a + h] departs by at most h^2 max|C''| / 8 from its chord, at equal parameters, and
//   |C''| <= n (n-1) max|D^2 b|. So the tolerance is kept, apart from the roundings of m and of the points.
// Fails: the largest second difference decides everywhere, also where the curve is nearly straight.
#pragma once

#include <algorithm>

#include "core/evaluate/methods/horner_bernstein.hpp"
#include "core/flatten/flattening.hpp"

namespace bezierbench {

/// The bound of |C''|.
template <int Dimension, int Degree>
double largest_second_derivative(const Curve<Form::bernstein, double, Dimension, Degree>& curve) {
  const int n = curve.degree();
  double largest = 0;
  for (int i = 0; i + 2 <= n; ++i) {
    double square = 0;
    for (int axis = 0; axis < Dimension; ++axis) {
      const double second = (curve(axis, i + 2) - curve(axis, i + 1)) - (curve(axis, i + 1) - curve(axis, i));
      square += second * second;
    }
    largest = std::max(largest, square);
  }
  return n * (n - 1) * std::sqrt(largest);
}

/// The number of chords, infinite or NaN where it overflows.
template <int Dimension, int Degree>
double wang_count(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double tolerance) {
  return std::max(std::ceil(std::sqrt(largest_second_derivative(curve) / tolerance * 0.125)), 1.0);
}

/// Appends `wanted` chords with equal steps of t. The first and the last end are control points, and `Method` computes
/// the points between them. With more than max_chords wanted there are as many as that, and they are not complete.
template <class Method, class C, int Dimension, int Degree>
void add_equal_steps(const C& curve, const Curve<Form::bernstein, double, Dimension, Degree>& control_points,
                     double wanted, Flattening& chords) {
  chords.complete = wanted <= max_chords;
  const int count = chords.complete ? static_cast<int>(wanted) : max_chords;
  const auto prepared = Method::prepare(curve);
  const double step = 1.0 / count;
  chords.add(0, control_point(control_points, 0));
  for (int k = 1; k < count; ++k) chords.add(k * step, Method::evaluate(prepared, k * step));
  chords.add(1, control_point(control_points, control_points.degree()));
  chords.evaluations = count - 1;
}

struct WangCount {
  static constexpr MethodInfo info{.id = "wang_count",
                                   .label = "Equal steps by Wang's count",
                                   .problem = Problem::flattening,
                                   .min_degree = 1,
                                   .promise = "the tolerance, apart from roundings",
                                   .flops = "n(1+3d) + 1",
                                   .citation = "[Wang 1984]; [Filip et al. 1986]"};

  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    add_equal_steps<HornerBernstein>(curve, curve, wang_count(curve, tolerance), chords);
  }
};

}  // namespace bezierbench
