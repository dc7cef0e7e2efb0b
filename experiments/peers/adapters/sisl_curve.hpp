// SPDX-License-Identifier: MIT
// A Bezier curve as SISL takes it: a B-spline with one span.
#pragma once

#include <sisl.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/curve.hpp"

namespace bezierbench::peers {

struct FreeSislCurve {
  void operator()(SISLCurve* curve) const { freeCurve(curve); }
};
using SislCurve = std::unique_ptr<SISLCurve, FreeSislCurve>;

inline SislCurve sisl_curve(const CurveView<double>& curve) {
  constexpr int polynomial_b_spline = 1;
  constexpr int copy = 1;
  const int order = curve.degree + 1;
  std::vector<double> knots(2 * static_cast<std::size_t>(order), 0.0);
  std::fill(knots.begin() + order, knots.end(), 1.0);
  std::vector<double> vertices(curve.coefficients.begin(), curve.coefficients.end());
  return SislCurve(newCurve(order, order, knots.data(), vertices.data(), polynomial_b_spline, curve.dimension, copy));
}

}  // namespace bezierbench::peers
