// SPDX-License-Identifier: MIT
// The columns x, y, z of curve files and point files, and the numbers in them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::cli {

/// The name of an axis: x, y or z.
std::string axis_name(int axis);

/// Parses a file of coordinates. Throws Failure(input_output) as bundle::parse_csv() does, and where the first line has
/// numbers instead of the names of columns.
bundle::CsvDocument parse_coordinates(std::string_view text, const std::string& file_name);

/// The indices of the columns x, y, z, up to the first that is missing. They may stand in any order.
std::vector<std::size_t> axis_columns(const bundle::CsvDocument& csv);

/// Throws Failure(input_output) that shows the header of `csv` and a correct one.
[[noreturn]] void refuse_header(const bundle::CsvDocument& csv, const std::string& instead);

/// The number in a field. Throws Failure(input_output) that names file, line, row and column unless it is finite.
double number_at(const bundle::CsvDocument& csv, std::size_t row, std::size_t column);

}  // namespace bezierbench::cli
