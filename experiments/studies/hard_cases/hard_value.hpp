// SPDX-License-Identifier: MIT
// The distance of an exact value from the nearest rounding boundary, and its decimal digits.
#pragma once

#include <string>

#include "reference/rational.hpp"

namespace bezierbench::studies {

/// The distance of a dyadic value (denominator 1) from the nearest rounding boundary of the format, in units of the
/// spacing of its numbers at the value. Boundaries are the midpoints of neighbouring numbers, and the one from which on
/// numbers round to infinity. At 0 the spacing is the smallest subnormal, beyond the largest number that of the largest.
reference::Rational boundary_distance(const reference::Format& format, const reference::Rational& value);

/// A dyadic value in decimal with so many significant digits, rounded once, ties to even; with fewer digits where these
/// are exact. `0`, `-1.25`, `3e-324`: an exponent is written unless it is 0.
std::string significant(const reference::Rational& value, int digits);

}  // namespace bezierbench::studies
