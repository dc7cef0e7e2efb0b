// SPDX-License-Identifier: MIT
// The error of one computed coordinate, and the bound of a method for it.
#pragma once

#include <optional>

#include "core/bound/error_bound.hpp"
#include "core/curve_view.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {

/// Errors are infinite where the value is not finite.
struct CoordinateError {
  double exact = 0;      ///< the true value, rounded once
  double error = 0;      ///< |value - true value|, rounded once
  double error_ulp = 0;  ///< over the spacing of doubles at the true value
  double error_u = 0;    ///< over u p~; where p~ is 0: 0 for error 0, else infinite
};

/// Judges `value`; `p_tilde` is that of its axis.
CoordinateError coordinate_error(double value, const Rational& truth, const Rational& p_tilde);

/// The bound of a method for coordinate `axis` of the point at t, in coordinate units; infinite where nothing is
/// proved. `truth` is the true coordinate.
double coordinate_bound(const ErrorBound& bound, const CurveView<double>& curve, int axis, double t,
                        const Rational& truth, const Arithmetic& arithmetic = double_arithmetic);

/// bound / (u p~), rounded once; empty where the bound is infinite or p~ is 0.
std::optional<double> bound_units(double bound, const Rational& p_tilde,
                                  const Arithmetic& arithmetic = double_arithmetic);

}  // namespace bezierbench::reference
