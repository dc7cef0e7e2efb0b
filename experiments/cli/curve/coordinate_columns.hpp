// SPDX-License-Identifier: MIT
// The columns x, y, z of curve files and point files, and the numbers in them.
#pragma once

#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::cli {

/// The name of an axis: x, y or z.
std::string axis_name(int axis);

/// The indices of the columns x, y, z, up to the first that is missing. They may stand in any order.
std::vector<std::size_t> axis_columns(const bundle::CsvDocument& csv);

/// Throws Failure(input_output) that shows the header of `csv` and a correct one.
[[noreturn]] void refuse_header(const bundle::CsvDocument& csv, const std::string& instead);

/// The number in a field. Throws Failure(input_output) that names file, line, row and column unless it is finite.
double number_at(const bundle::CsvDocument& csv, std::size_t row, std::size_t column);

}  // namespace bezierbench::cli
