// SPDX-License-Identifier: MIT
// The scales of a derivative's error: p~ and A of core/bound/derivative_bound.hpp, and the proved bound, with Euclidean
// norms as in TrialScale.
#pragma once

#include <vector>

#include "core/bound/derivative_bound.hpp"
#include "core/curve_view.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::metric {

/// Scales of the derivative of one order of one curve at one t. Reusable.
class DerivativeScale {
 public:
  /// Of a curve in Bernstein or power form. Must be called before anything else.
  void set(const CurveView<double>& curve, int order, double t);

  /// p~ of the derivative, over its own coefficients; infinite where one of them overflows.
  [[nodiscard]] double p_tilde() const { return p_tilde_; }

  /// error / (u p~); where p~ is 0: 0 for error 0, else infinite.
  [[nodiscard]] double in_bound_units(double error, const reference::Arithmetic& arithmetic) const;

  /// The bound in coordinate units; to be compared by TrialScale::violates.
  [[nodiscard]] double bound(const DerivativeBound& bound, const reference::Arithmetic& arithmetic) const;

 private:
  /// (n)_k sum_j C(k,j) |b_(i+j)|, the coefficients of A.
  [[nodiscard]] std::vector<double> magnitudes(const CurveView<double>& curve) const;

  int dimension_ = 0;
  int degree_ = 0;
  int order_ = 0;
  double t_ = 0;
  double p_tilde_ = 0;
  double differences_ = 0;  ///< A
  double largest_ = 0;      ///< of the coefficients of A, or of the derivative where no differences are formed
  reference::ExactCurve exact_;
  reference::TrialScale scale_;
};

}  // namespace bezierbench::metric
