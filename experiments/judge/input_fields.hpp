// SPDX-License-Identifier: MIT
// How an input that can be replayed is written: every bit of it, in hexadecimal floating point.
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
/// likewise, none but for rational curves.
std::vector<std::string> input_fields(const sample::Trial& trial, int dimension);

/// About how many bytes they have.
std::size_t bytes_of_input(const sample::Cell& cell);

/// What those columns hold of one input.
struct InputTexts {
  std::string_view t;
  std::string_view coefficients;
  std::string_view weights;
};

/// Reads such fields; nothing where one is not a finite number or there are more or fewer than the cell's curve has.
std::optional<sample::Trial> parse_input(const InputTexts& texts, const sample::Cell& cell);

}  // namespace bezierbench::judge
