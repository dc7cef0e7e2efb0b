// SPDX-License-Identifier: MIT
// Tables for people that fit the terminal.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace bezierbench::cli {

/// A table with aligned columns: one line per row where `width` is empty or wide enough. In a narrower terminal the
/// last column is broken at spaces, if enough of it stays; else as many columns as fit stay aligned, and each row's
/// other fields follow below it, with the names of their columns where these are several. `lines` are the header and the
/// rows, all of one length. Fields are escaped as reference/number/echo.hpp describes. Colours are those of standard output.
std::string fitted(std::vector<std::vector<std::string>> lines, std::optional<std::size_t> width);

}  // namespace bezierbench::cli
