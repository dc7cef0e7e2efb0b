// SPDX-License-Identifier: MIT
// Tables for people: columns that line up.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::cli {

/// One line of text per line of fields; every column is as wide as its widest field. Lines may have fewer fields; one
/// of a single field is a heading, which widens no column. Fields are shown as experiments/echo.hpp says.
std::string aligned(std::vector<std::vector<std::string>> lines);

/// A whole CSV text, header and rows, likewise. Throws as bundle::parse_csv().
std::string aligned_csv(std::string_view csv);

}  // namespace bezierbench::cli
