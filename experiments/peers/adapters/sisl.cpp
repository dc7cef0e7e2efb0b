// SPDX-License-Identifier: MIT
// SISL (SINTEF): s1227 on the curve as a B-spline with one span.
//
// Computes: the B-splines that are not zero at t, then their sum with the vertices.
#include <limits>

#include "experiments/peers/adapter.hpp"
#include "experiments/peers/adapters/sisl_curve.hpp"
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

}  // namespace bezierbench::peers
