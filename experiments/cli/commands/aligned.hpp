// SPDX-License-Identifier: MIT
// Tables with aligned columns, for people.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::cli {

/// One line of text per line of fields; every column is as wide as its widest field. A line may have fewer fields than
/// others. A line of one field is a heading and does not widen its column. Fields are escaped as experiments/echo.hpp
/// describes.
std::string aligned(std::vector<std::vector<std::string>> lines);

/// A whole CSV text, header and rows, with aligned columns. Throws as bundle::parse_csv() does.
std::string aligned_csv(std::string_view csv);

}  // namespace bezierbench::cli
