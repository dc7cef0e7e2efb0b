// SPDX-License-Identifier: MIT
// The methods for point projection behind function pointers.
#pragma once

#include <concepts>
#include <span>

#include "core/curve.hpp"
#include "core/curve_view.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// The parameter at which a method finds the curve nearest to the point.
struct FootPoint {
  double t = 0;
  double distance = 0;    ///< |C(t) - P|, in coordinate units
  int candidates = 0;     ///< parameters or pieces among which the nearest was sought
  bool converged = true;  ///< false where the method gave up early
};

/// One method, for curves of one dimension.
struct ProjectionKernel {
  const MethodInfo* info;
  int dimension;
  /// Projects `point`, which has as many coordinates as the curve. `curve` is in the form of `info`, of a degree that
  /// the method supports, and has no pole in [0, 1].
  FootPoint (*project)(const CurveView<double>& curve, std::span<const double> point);
  /// The bound of |(C - P).C'| at t that the method states, over the unit of polished_residual_bound, for a degree and
  /// a dimension; null for none.
  double (*residual_bound)(int degree, int dimension) = nullptr;
};

/// All methods, in roster order. Dimension is 1, 2 or 3.
std::span<const ProjectionKernel> projection_kernels(int dimension);

// The concept of a method for point projection: `info`, and one function from a curve and a point to the parameter in
// [0, 1] where the curve is nearest to the point.

template <class M>
concept ProjectionMethod = requires(const Curve<M::info.form, double, 2>& curve, const Point<double, 2>& point) {
  requires M::info.problem == Problem::projection;
  { M::project(curve, point) } -> std::same_as<FootPoint>;
};

}  // namespace bezierbench
