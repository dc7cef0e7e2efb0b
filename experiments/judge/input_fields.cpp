// SPDX-License-Identifier: MIT
#include "experiments/judge/input_fields.hpp"

#include <algorithm>
#include <cmath>

#include "reference/number/number.hpp"

namespace bezierbench::judge {
namespace {

std::optional<double> finite(std::string_view text) {
  const auto value = number::parse_number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

void append(std::string& list, double value) {
  if (!list.empty()) list += ' ';
  list += number::hexadecimal(value);
}

/// The numbers of a list that must have `count` of them.
std::optional<std::vector<double>> parse_list(std::string_view list, std::size_t count) {
  std::vector<double> values;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    const auto value = finite(list.substr(0, end));
    if (!value) return std::nullopt;
    values.push_back(*value);
    list.remove_prefix(end);
    if (list.empty()) break;
    list.remove_prefix(1);
    if (list.empty()) return std::nullopt;  // a blank at the end
  }
  if (values.size() != count) return std::nullopt;
  return values;
}

}  // namespace

const std::vector<std::string>& input_columns() {
  static const std::vector<std::string> columns{"t", "coefficients", "weights"};
  return columns;
}

std::vector<std::string> input_fields(const sample::Trial& trial, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  std::string coefficients;
  for (std::size_t axis = 0; axis < d; ++axis)
    for (std::size_t k = axis; k < trial.coefficients.size(); k += d) append(coefficients, trial.coefficients[k]);
  std::string weights;
  for (const double weight : trial.weights) append(weights, weight);
  return {number::hexadecimal(trial.t), coefficients, weights};
}

std::size_t bytes_of_input(const sample::Cell& cell) {
  constexpr std::size_t number = 23;  // -0x1.23456789abcdep+12, and a blank
  const auto axes = static_cast<std::size_t>(cell.dimension) + (cell.form == Form::rational ? 1 : 0);
  return number * (1 + axes * (static_cast<std::size_t>(cell.degree) + 1));
}

std::optional<sample::Trial> parse_input(const InputTexts& texts, const sample::Cell& cell) {
  const auto d = static_cast<std::size_t>(cell.dimension);
  const std::size_t count = static_cast<std::size_t>(cell.degree) + 1;
  const auto t = finite(texts.t);
  const auto axis_by_axis = parse_list(texts.coefficients, count * d);
  const auto weights = parse_list(texts.weights, cell.form == Form::rational ? count : 0);
  if (!t || !axis_by_axis || !weights) return std::nullopt;
  sample::Trial trial;
  trial.t = *t;
  trial.weights = *weights;
  trial.coefficients.resize(count * d);
  for (std::size_t axis = 0; axis < d; ++axis)
    for (std::size_t i = 0; i < count; ++i) trial.coefficients[i * d + axis] = (*axis_by_axis)[axis * count + i];
  return trial;
}

}  // namespace bezierbench::judge
