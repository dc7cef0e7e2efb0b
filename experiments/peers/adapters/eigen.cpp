// SPDX-License-Identifier: MIT
// Eigen's Spline (unsupported module) with one span.
//
// Computes: the Cox-de Boor recursion for all basis functions, then their sum with the control points; allocates for
// each point.
#include <unsupported/Eigen/Splines>

#include "experiments/peers/adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

struct EigenSpline {
  static constexpr MethodInfo info{.id = "peer_eigen_spline",
                                   .label = "Eigen Spline",
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .bit_stable = false,
                                   .flops = "that of the library, O(n^2)",
                                   .cost_exponent = 2,
                                   .citation = "Eigen, unsupported Splines module"};

  template <int Dimension>
  using Prepared = Eigen::Spline<double, Dimension, Eigen::Dynamic>;

  /// Eigen cannot lay out control points in one dimension.
  template <int Dimension>
  requires(Dimension > 1) static Prepared<Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve) {
    const int n = curve.degree();
    typename Prepared<Dimension>::KnotVectorType knots(2 * (n + 1));
    knots.head(n + 1).setZero();
    knots.tail(n + 1).setOnes();
    typename Prepared<Dimension>::ControlPointVectorType points(Dimension, n + 1);
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < Dimension; ++axis) points(axis, i) = curve(axis, i);
    return {knots, points};
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const Prepared<Dimension>& spline, double t) {
    return spline(t).matrix();
  }
};

}  // namespace

std::span<const Kernel<double>> peer_eigen_spline(int dimension) { return kernels_of<EigenSpline>(dimension); }

}  // namespace bezierbench::peers
