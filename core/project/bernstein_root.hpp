// SPDX-License-Identifier: MIT
// A first estimate of the only root of a polynomial in Bernstein form: the zero of its control polygon, then Newton
// steps until the estimate is so near that few steps on the curve itself remain.
//
// Source: [Moerken and Reimers 2007], zeros of the control polygon as estimates.
// Cost: 3 flops for each of the n(n+1)/2 points of de Casteljau's triangle per step; most often three or four steps.
#pragma once

#include "core/project/polygon.hpp"
#include "core/project/refine.hpp"

namespace bezierbench {

/// The value of f, and its derivative divided by the degree n.
struct BernsteinSlope {
  double value;
  double derivative;
};

/// Evaluates f at t by de Casteljau's algorithm, whose last level but one gives the derivative. The degree is at least
/// 1.
template <int Points>
BernsteinSlope bernstein_slope(Polygon<1, Points> f, double t) {
  const double s = 1 - t;
  each_of_triangle<count_of(Points, -1), 2>(degree_of<1>(f), [&](int i) { f[i] = s * f[i] + t * f[i + 1]; });
  return {s * f[0] + t * f[1], f[1] - f[0]};
}

/// The parameter at which the control polygon of f first crosses zero. Its first and last coefficient have different
/// signs.
template <int Points>
double zero_of_control_polygon(const Polygon<1, Points>& f) {
  int k = 0;
  while ((f[k + 1] < 0) == (f[0] < 0)) ++k;
  return (k + f[k] / (f[k] - f[k + 1])) / degree_of<1>(f);
}

/// An estimate of the root of f in (0, 1). The first and last coefficient of f have different signs. The estimate has
/// no guaranteed accuracy: next to the root, values of f may consist of rounding errors only.
template <int Points>
RootEstimate estimate_root(const Polygon<1, Points>& f) {
  constexpr int max_steps = 16;
  constexpr double short_step = 0x1p-18;
  RootEstimate root{zero_of_control_polygon(f), 1};
  for (int k = 0; k < max_steps && std::abs(root.step) > short_step; ++k) {
    const auto [value, derivative] = bernstein_slope(f, root.t);
    const double next = root.t - value / (degree_of<1>(f) * derivative);
    if (!(next > 0 && next < 1)) return {root.t, 1};
    root = {next, next - root.t};
  }
  return root;
}

}  // namespace bezierbench
