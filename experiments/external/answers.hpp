// SPDX-License-Identifier: MIT
// Answers to the inputs of accuracy studies, as CSV, from a machine that this program does not reach: a GPU, an FPGA, a
// computer without a network. Every row of the file is one input; its last columns hold the answer.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/external/method.hpp"

namespace bezierbench::external {

/// The columns of the answer, one per axis: x, y, z. Those beyond the dimension of the input stay empty.
inline constexpr std::array<std::string_view, 3> answer_columns{"x", "y", "z"};

/// The default id of a file of answers: answers_ and the letters and digits of its name.
std::string answers_id(std::string_view file_name);

/// The answers of a table with the columns form, dimension, degree, t, coefficients, weights, x, y, z; an input is
/// found by its bits. Throws Failure(input_output) that names file, line and column for a field that cannot be read, and
/// Failure(usage) for an invalid id.
std::shared_ptr<const Method> answers(const bundle::CsvDocument& table, const std::string& id,
                                      const std::string& sha256);

}  // namespace bezierbench::external
