// SPDX-License-Identifier: MIT
// A method's proved bound over a whole class of curves; it does not depend on the drawn inputs.
#pragma once

#include "core/bound/error_bound.hpp"
#include "core/curve_view.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::metric {

/// Curves of one form and degree with every coordinate of their coefficients in [-range, range], at t in [t_min,
/// t_max].
struct CurveClass {
  Form form = Form::bernstein;
  int dimension = 2;
  int degree = 0;
  double range = 1;
  double t_min = 0;
  double t_max = 1;
};

/// No error of a member is larger; infinite where that is not proved.
struct ClassBound {
  double coordinate = 0;  ///< in coordinate units
  double in_u = 0;        ///< in units of u p~, for members with p~ >= min_p_tilde()
};

/// For a smaller p~ the class has no bound in units of u p~, because underflow terms do not shrink with p~.
double min_p_tilde(const CurveClass& of, const reference::Arithmetic& arithmetic);

/// The bound of a method with its worst amplification over the class. Known to a relative 2^-20, as TrialScale::bound.
/// Infinite for rational curves, because the class does not limit weights, and where a result on the way may
/// overflow.
ClassBound class_bound(const ErrorBound& bound, const CurveClass& of, const reference::Arithmetic& arithmetic);

}  // namespace bezierbench::metric
