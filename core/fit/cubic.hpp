// SPDX-License-Identifier: MIT
// A cubic Bezier segment relative to a data point P. All values are computed from b_j - P, which is small near the
// point, however far both are from the origin.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/project/polygon.hpp"

namespace bezierbench {

template <int Dimension>
using Cubic = std::array<Point<double, Dimension>, 4>;

/// The Bernstein polynomials B_0 to B_3 of degree 3 at t.
inline std::array<double, 4> cubic_basis(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// C(t) - P, C'(t) and C''(t).
template <int Dimension>
struct Offset {
  Point<double, Dimension> offset;
  Point<double, Dimension> velocity;
  Point<double, Dimension> acceleration;
};

template <int Dimension>
Offset<Dimension> offset_at(const Cubic<Dimension>& b, const Point<double, Dimension>& point, double t) {
  const double s = 1 - t;
  Offset<Dimension> result;
  for (int axis = 0; axis < Dimension; ++axis) {
    const double o0 = b[0][axis] - point[axis];
    const double o1 = b[1][axis] - point[axis];
    const double o2 = b[2][axis] - point[axis];
    const double o3 = b[3][axis] - point[axis];
    const double left = s * (s * o0 + t * o1) + t * (s * o1 + t * o2);
    const double right = s * (s * o1 + t * o2) + t * (s * o2 + t * o3);
    result.offset[axis] = s * left + t * right;
    result.velocity[axis] = 3 * (right - left);
    result.acceleration[axis] = 6 * (s * ((o2 - o1) - (o1 - o0)) + t * ((o3 - o2) - (o2 - o1)));
  }
  return result;
}

/// f = (C - P).C', whose roots are the foot points of P, and its derivative.
template <int Dimension>
struct Slope {
  explicit Slope(const Offset<Dimension>& at)
      : value(dot<Dimension>(at.offset, at.velocity)),
        speed_squared(dot<Dimension>(at.velocity, at.velocity)),
        derivative(speed_squared + dot<Dimension>(at.offset, at.acceleration)) {}
  double value;
  double speed_squared;
  double derivative;
};

/// |v|^2.
template <int Dimension>
double squared(const Point<double, Dimension>& v) {
  return dot<Dimension>(v, v);
}

/// Takes at most `max_steps` steps from t in [0, 1] towards a foot point: Newton steps where the distance is convex,
/// else Gauss-Newton steps. The curve at the parameter returned is never farther from the point than at t.
template <int Dimension>
double approach(const Cubic<Dimension>& b, const Point<double, Dimension>& point, double t, int max_steps) {
  auto at = offset_at<Dimension>(b, point, t);
  double distance = squared<Dimension>(at.offset);
  for (int k = 0; k < max_steps; ++k) {
    const Slope<Dimension> f(at);
    const double steepness = f.derivative > 0 ? f.derivative : f.speed_squared;
    if (f.value == 0 || !(steepness > 0)) return t;
    const double next = std::clamp(t - f.value / steepness, 0.0, 1.0);
    at = offset_at<Dimension>(b, point, next);
    const double next_distance = squared<Dimension>(at.offset);
    if (!(next_distance < distance)) return t;
    t = next;
    distance = next_distance;
  }
  return t;
}

/// A proved upper bound of the distance of the point from C(t), for coordinates up to 1 in magnitude. Let a be the
/// largest coordinate of all b_j - P. One rounding of each difference and 13 in de Casteljau's three levels change a
/// coordinate by less than 16 u a and the length by less than sqrt(3) times that. The roundings of the length itself
/// are below u a.
template <int Dimension>
double distance_bound(const Cubic<Dimension>& b, const Point<double, Dimension>& point, double t) {
  double largest = 0;
  for (const auto& control : b)
    for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(control[axis] - point[axis]));
  return length<Dimension>(offset_at<Dimension>(b, point, t).offset) + 0x1p-48 * largest;
}

}  // namespace bezierbench
