// SPDX-License-Identifier: MIT
#include "experiments/studies/input_fields.hpp"

#include <cmath>

#include "experiments/number/number.hpp"

namespace bezierbench::studies {
namespace {

std::optional<double> finite(std::string_view text) {
  const auto value = number::parse_number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

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

std::optional<sample::Trial> parse_input(std::string_view t, std::string_view coefficients, const sample::Cell& cell) {
  const auto d = static_cast<std::size_t>(cell.dimension);
  const std::size_t count = static_cast<std::size_t>(cell.degree) + 1;
  const auto parameter = finite(t);
  if (!parameter) return std::nullopt;
  sample::Trial trial;
  trial.t = *parameter;
  trial.coefficients.resize(count * d);
  for (std::size_t axis = 0; axis < d; ++axis)
    for (std::size_t i = 0; i < count; ++i) {
      const bool last = axis + 1 == d && i + 1 == count;
      const std::size_t end = coefficients.find(' ');
      if ((end == std::string_view::npos) != last) return std::nullopt;
      const auto value = finite(coefficients.substr(0, end));
      if (!value) return std::nullopt;
      trial.coefficients[i * d + axis] = *value;
      coefficients.remove_prefix(last ? coefficients.size() : end + 1);
    }
  return trial;
}

}  // namespace bezierbench::studies
