// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/curve_table.hpp"

#include "experiments/number/number.hpp"
#include "reference/error/coordinate_error.hpp"

namespace bezierbench::cli {

std::vector<std::string> judged_coordinate(double value, const reference::Rational& truth,
                                           const reference::Rational& p_tilde) {
  const auto judged = reference::coordinate_error(value, truth, p_tilde);
  return {number::decimal(value), number::decimal(judged.exact), number::decimal(judged.error),
          number::decimal(judged.error_ulp), number::decimal(judged.error_u)};
}

std::string bound_field(double bound, const reference::Rational& p_tilde) {
  const auto units = reference::bound_units(bound, p_tilde);
  return units ? number::decimal(*units) : "";
}

}  // namespace bezierbench::cli
