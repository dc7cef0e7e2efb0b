// SPDX-License-Identifier: MIT
// Bounds of companion problems at one point of their answer. The scales of a derivative's error: p~ and A of
// core/bound/derivative_bound.hpp, and the proved bound, with Euclidean norms as in TrialScale.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/bound/bspline_bound.hpp"
#include "core/bound/derivative_bound.hpp"
#include "core/bound/grid_bound.hpp"
#include "core/curve_view.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::metric {

/// Scales of the derivative of one order of one curve at one t. Reusable.
class DerivativeScale {
 public:
  /// Of a curve in Bernstein, power or rational form. Must be called before anything else.
  void set(const CurveView<double>& curve, int order, double t);

  /// p~ of the derivative, over its own coefficients, or S_k of a rational curve; infinite where it overflows, and where
  /// there is no derivative.
  [[nodiscard]] double p_tilde() const { return p_tilde_; }

  /// error / (u p~); where p~ is 0: 0 for error 0, else infinite.
  [[nodiscard]] double in_bound_units(double error, const reference::Arithmetic& arithmetic) const;

  /// The bound in coordinate units; to be compared by TrialScale::violates.
  [[nodiscard]] double bound(const DerivativeBound& bound, const reference::Arithmetic& arithmetic) const;

 private:
  /// What A of one order sums.
  struct Differences {
    double sum = 0;      ///< A
    double largest = 0;  ///< of its coefficients, or of those of the derivative where no differences are formed
  };
  /// A of a polynomial curve in Bernstein form; `norms` are the sizes of its control points.
  Differences differences(const std::vector<double>& norms, int order);
  /// The underflow term on one axis; infinite where a result may leave the range.
  [[nodiscard]] double underflow(const DerivativeBound& bound, int order, double largest,
                                 const reference::Arithmetic& arithmetic) const;
  [[nodiscard]] double quotient_bound(const DerivativeBound& bound, const reference::Arithmetic& arithmetic) const;

  int dimension_ = 0;
  int degree_ = 0;
  int order_ = 0;
  double t_ = 0;
  double p_tilde_ = 0;
  Differences differences_;
  std::vector<Differences> numerators_;    ///< of a rational curve, by order
  std::vector<Differences> denominators_;  ///< likewise of its weights
  double weight_ = 0;                      ///< |W|
  reference::ExactCurve exact_;
  reference::TrialScale scale_;
};

/// The bound of point k of `steps`, for a curve of this degree.
inline reference::BoundAtDegree bound_at(const GridBound& bound, int degree, int k, int steps,
                                         const reference::Arithmetic& arithmetic) {
  const ErrorBound amplification_only{.text = bound.text,
                                      .amplification = bound.amplification,
                                      .factor = [](int, double) { return 0.0; },
                                      .underflow = [](int) { return 0.0; },
                                      .underflow_scales_with_coefficients = bound.underflow_scales_with_coefficients};
  reference::BoundAtDegree at(amplification_only, degree, arithmetic);
  at.factor = bound.factor(degree, k, arithmetic.unit_roundoff);
  at.underflow = std::ceil(bound.underflow(degree, steps));
  at.growth = bound.growth(degree, steps);
  return at;
}

// The bound of a point of a B-spline curve, or of a control point of a knot span in Bernstein form, in coordinate
// units.

/// The sizes in a bound: on one axis or, with Euclidean norms as magnitudes, on all axes at once (see TrialScale).
struct BsplineSizes {
  int degree;
  int axes;
  double p_tilde;
  double largest;  ///< max |d_i|
};

/// Infinite where a result on the way may overflow.
inline double bound_at(const BsplineBound::Part& bound, const BsplineSizes& sizes,
                       const reference::Arithmetic& arithmetic) {
  const double u = arithmetic.unit_roundoff;
  if (!stays_in_range(sizes.largest, sizes.degree, u)) return std::numeric_limits<double>::infinity();
  const double lost = std::ceil(bound.underflow(sizes.degree)) * sizes.axes * (1 + sizes.largest);
  return bound.factor(sizes.degree, u) * u * sizes.p_tilde + lost * arithmetic.smallest_subnormal;
}

/// What the bound of a rational curve depends on besides.
struct BsplineWeightSizes {
  double sum;              ///< W = sum w_i N_i, or sum w_i c_i
  double largest;          ///< max w_i
  double largest_product;  ///< max w_i |d_i|
};

/// The bound of a curve with weights w_i > 0, of which p~ = sum w_i |d_i| N_i / W, by docs/proofs/homogeneous.md.
/// Infinite where a result on the way may overflow, and where underflow may take an eighth of W.
inline double bound_at(const BsplineBound::Part& bound, const BsplineSizes& sizes, const BsplineWeightSizes& weights,
                       const reference::Arithmetic& arithmetic) {
  const double u = arithmetic.unit_roundoff;
  const double eta = arithmetic.smallest_subnormal;
  const double factor = bound.factor(sizes.degree, u);
  const double phi = factor * u;
  const double underflow = std::ceil(bound.underflow(sizes.degree)) * eta;
  const double from_sum = underflow * (1 + weights.largest);
  const double from_products = (underflow * (1 + weights.largest_product) + eta) * sizes.axes;
  const bool in_range = stays_in_range(std::max(weights.largest, weights.largest_product), sizes.degree, u) &&
                        stays_in_range(sizes.largest, sizes.degree, u);
  if (!in_range || !(phi <= 0.125) || !(from_sum <= weights.sum / 8)) return std::numeric_limits<double>::infinity();
  const double rounding = (2 * factor + (2 + u) * (1 + phi)) / (1 - phi) * u * sizes.p_tilde;
  return rounding + 2 * (from_sum * sizes.p_tilde + from_products) / weights.sum + eta * sizes.axes;
}

}  // namespace bezierbench::metric
