// SPDX-License-Identifier: MIT
// The fields of an input that can be replayed: every number in hexadecimal floating point, which keeps all bits.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/sample/draw.hpp"

namespace bezierbench::judge {

/// t,coefficients,weights
const std::vector<std::string>& input_columns();

/// The fields of those columns: coefficients separated by blanks, all of the first axis, then of the next; weights
/// likewise, empty unless the curve is rational.
std::vector<std::string> input_fields(const sample::Trial& trial, int dimension);

/// The approximate size of these fields in bytes.
std::size_t bytes_of_input(const sample::Cell& cell);

/// The texts of those columns for one input.
struct InputTexts {
  std::string_view t;
  std::string_view coefficients;
  std::string_view weights;
};

/// Reads such fields. Empty where a number is not finite or their count is not that of the cell's curve.
std::optional<sample::Trial> parse_input(const InputTexts& texts, const sample::Cell& cell);

}  // namespace bezierbench::judge
