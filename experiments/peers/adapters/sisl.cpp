// SPDX-License-Identifier: MIT
// SISL (SINTEF): s1227 on the curve as a B-spline with one span.
//
// Computes: the B-splines that are not zero at t, then their sum with the vertices.
#include <sisl.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "experiments/peers/adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

struct Sisl {
  static constexpr MethodInfo info{.id = "peer_sisl",
                                   .label = "SISL B-spline",
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .bit_stable = false,
                                   .flops = "that of the library, O(n^2)",
                                   .cost_exponent = 2,
                                   .citation = "SISL, s1227"};

  struct Free {
    void operator()(SISLCurve* curve) const { freeCurve(curve); }
  };
  template <int Dimension>
  struct Prepared {
    std::unique_ptr<SISLCurve, Free> curve;
  };

  template <int Dimension>
  static Prepared<Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve) {
    constexpr int polynomial_b_spline = 1;
    constexpr int copy = 1;
    const int order = curve.degree() + 1;
    std::vector<double> knots(2 * static_cast<std::size_t>(order), 0.0);
    std::fill(knots.begin() + order, knots.end(), 1.0);
    std::vector<double> vertices;
    for (int i = 0; i < order; ++i)
      for (int axis = 0; axis < Dimension; ++axis) vertices.push_back(curve(axis, i));
    return {std::unique_ptr<SISLCurve, Free>(
        newCurve(order, order, knots.data(), vertices.data(), polynomial_b_spline, Dimension, copy))};
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const Prepared<Dimension>& prepared, double t) {
    Point<double, Dimension> point;
    constexpr int derivatives = 0;
    int knot_before = 0;
    int status = 0;
    s1227(prepared.curve.get(), derivatives, t, &knot_before, point.data(), &status);
    if (status < 0) point.setConstant(std::numeric_limits<double>::quiet_NaN());
    return point;
  }
};

}  // namespace

std::span<const Kernel<double>> peer_sisl(int dimension) { return kernels_of<Sisl>(dimension); }

}  // namespace bezierbench::peers
