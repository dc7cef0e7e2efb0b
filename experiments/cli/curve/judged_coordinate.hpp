// SPDX-License-Identifier: MIT
// The error of one computed coordinate, as the `curve` commands print it.
#pragma once

#include <string>
#include <vector>

#include "reference/rational.hpp"

namespace bezierbench::cli {

/// The fields of the columns value,exact,error,error_ulp,error_u. Errors are infinite where `value` is not finite;
/// error_u is infinite where p~ is 0 and the error is not.
std::vector<std::string> judged_coordinate(double value, const reference::Rational& truth,
                                           const reference::Rational& p_tilde);

/// The field of the column bound_u: bound / (u p~); empty where the bound is infinite or p~ is 0.
std::string bound_field(double bound, const reference::Rational& p_tilde);

}  // namespace bezierbench::cli
