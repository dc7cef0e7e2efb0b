// SPDX-License-Identifier: MIT
// On which side of a number an easing curve is, by exact integers.
#pragma once

#include "core/easing/easing.hpp"

namespace bezierbench {

/// The sign of y(t*) - (a + b) / 2, where t* in (0, 1) solves x(t*) = x; 0 where they are equal. x is in (0, 1), x1
/// and x2 in [0, 1], all numbers are finite. Takes microseconds; up to milliseconds where the exponents are hundreds
/// apart.
///
/// x(t) - x has one root in (0, 1), of whatever multiplicity, and is not 0 at 0 and 1, so that its Tarski query with
/// Q = y(t) - (a + b) / 2 is the sign: the number of variations at 0 less that at 1 of the signed remainder sequence of
/// P = x(t) - x and P' Q. Source: [Basu et al. 2006], theorem 2.61.
int exact_easing_sign(const EasingCurve<double>& curve, double x, double a, double b);

}  // namespace bezierbench
