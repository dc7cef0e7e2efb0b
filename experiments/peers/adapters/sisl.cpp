// SPDX-License-Identifier: MIT
// A Bezier curve as SISL takes it: a B-spline with one span.
#include <sisl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/curve.hpp"
#include "experiments/peers/adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

struct FreeSislCurve {
  void operator()(SISLCurve* curve) const { freeCurve(curve); }
};
using SislCurve = std::unique_ptr<SISLCurve, FreeSislCurve>;

SislCurve sisl_curve(const CurveView<double>& curve) {
  constexpr int polynomial_b_spline = 1;
  constexpr int copy = 1;
  const int order = curve.degree + 1;
  std::vector<double> knots(2 * static_cast<std::size_t>(order), 0.0);
  std::fill(knots.begin() + order, knots.end(), 1.0);
  std::vector<double> vertices(curve.coefficients.begin(), curve.coefficients.end());
  return SislCurve(newCurve(order, order, knots.data(), vertices.data(), polynomial_b_spline, curve.dimension, copy));
}

// SISL (SINTEF): s1227 on the curve as a B-spline with one span.
//
// Computes: the B-splines that are not zero at t, then their sum with the vertices.

struct Sisl {
  static constexpr MethodInfo info{.id = "peer_sisl",
                                   .label = "SISL B-spline",
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .bit_stable = false,
                                   .flops = "that of the library, O(n^2)",
                                   .cost_exponent = 2,
                                   .citation = "SISL, s1227"};

  template <int Dimension>
  struct Prepared {
    SislCurve curve;
  };

  template <int Dimension>
  static Prepared<Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve) {
    const auto count = static_cast<std::size_t>((curve.degree() + 1) * Dimension);
    return {sisl_curve({Form::bernstein, Dimension, curve.degree(), std::span(curve.data(), count)})};
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

// SISL (SINTEF): s1957, the closest point of a B-spline, here of one span.
//
// Computes: Newton's method from a first guess; its manual says that it is fast and works well in clear cut cases, and
// does not guarantee the right solution.

namespace {

constexpr auto closest_info =
    companion_info("peer_sisl_closest", "SISL, closest point of a B-spline", Problem::projection, "SISL, s1957");

FootPoint project(const CurveView<double>& curve, std::span<const double> point) {
  const auto b_spline = sisl_curve(curve);
  std::vector<double> target(point.begin(), point.end());
  double largest = 0;
  for (const double x : curve.coefficients) largest = std::max(largest, std::abs(x));
  const double resolution = 0x1p-40 * largest;
  constexpr double unused = 0;
  int status = 0;
  double t = 0;
  double distance = 0;
  s1957(b_spline.get(), target.data(), curve.dimension, unused, resolution, &t, &distance, &status);
  if (status < 0) t = distance = std::numeric_limits<double>::quiet_NaN();
  return {.t = t, .distance = distance};
}

}  // namespace

std::span<const ProjectionKernel> peer_sisl_closest(int dimension) {
  static constexpr std::array kernels{ProjectionKernel{&closest_info, 2, project},
                                      ProjectionKernel{&closest_info, 3, project}};
  return in_dimension(kernels, dimension);
}

}  // namespace bezierbench::peers
