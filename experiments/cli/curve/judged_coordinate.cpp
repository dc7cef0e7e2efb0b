// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/judged_coordinate.hpp"

#include <cmath>
#include <limits>

#include "experiments/number/number.hpp"

namespace bezierbench::cli {
namespace {

/// u p~, exactly.
reference::Rational unit_of(const reference::Rational& p_tilde) { return p_tilde * reference::Rational{1, 1, -53}; }

}  // namespace

std::vector<std::string> judged_coordinate(double value, const reference::Rational& truth,
                                           const reference::Rational& p_tilde) {
  using reference::binary64;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double error = infinite;
  double error_ulp = infinite;
  double error_u = infinite;
  if (std::isfinite(value)) {
    const auto difference = abs(reference::exactly(value) - truth);
    error = reference::round_to(binary64, difference);
    error_ulp = reference::quotient(binary64, difference, reference::ulp(truth));
    if (difference.numerator == 0)
      error_u = 0;
    else if (p_tilde.numerator != 0)
      error_u = reference::quotient(binary64, difference, unit_of(p_tilde));
  }
  return {number::decimal(value), number::decimal(reference::round_to(binary64, truth)), number::decimal(error),
          number::decimal(error_ulp), number::decimal(error_u)};
}

std::string bound_field(double bound, const reference::Rational& p_tilde) {
  if (!std::isfinite(bound) || p_tilde.numerator == 0) return "";
  return number::decimal(reference::quotient(reference::binary64, reference::exactly(bound), unit_of(p_tilde)));
}

}  // namespace bezierbench::cli
