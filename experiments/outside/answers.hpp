// SPDX-License-Identifier: MIT
// Inputs of accuracy studies as CSV, and answers to them from a machine that this program does not reach: a GPU, an
// FPGA, a computer without a network. Every row of the file is one input; its last columns are to be filled in.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/outside/method.hpp"

namespace bezierbench::outside {

/// The columns of the answer, one per axis: x, y, z. Those beyond the dimension of the input stay empty.
inline constexpr std::array<std::string_view, 3> answer_columns{"x", "y", "z"};

/// The id of a file of answers that was given none: answers_ and what its name has of letters and digits.
std::string answers_id(std::string_view file_name);

/// The answers of a table with the columns form, dimension, degree, t, coefficients, weights, x, y, z; an input is
/// found by its bits. Throws Failure(input_output) that names file, line and column for a field that cannot be read, and
/// Failure(usage) for an id that is none.
std::shared_ptr<const Method> answers(const bundle::CsvDocument& table, const std::string& id,
                                      const std::string& sha256);

}  // namespace bezierbench::outside
