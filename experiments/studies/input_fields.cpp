// SPDX-License-Identifier: MIT
#include "experiments/studies/input_fields.hpp"

#include "experiments/number/number.hpp"

namespace bezierbench::studies {

const std::vector<std::string>& input_columns() {
  static const std::vector<std::string> columns{"t", "coefficients"};
  return columns;
}

std::vector<std::string> input_fields(const sample::Trial& trial, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  std::string coefficients;
  for (std::size_t axis = 0; axis < d; ++axis)
    for (std::size_t k = axis; k < trial.coefficients.size(); k += d) {
      if (!coefficients.empty()) coefficients += ' ';
      coefficients += number::hexadecimal(trial.coefficients[k]);
    }
  return {number::hexadecimal(trial.t), coefficients};
}

}  // namespace bezierbench::studies
