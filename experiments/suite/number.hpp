// SPDX-License-Identifier: MIT
// Numbers as text, the same in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bezierbench::suite {

/// Reads decimal (`1e-3`) and hexadecimal floating point (`0x1.8p-1`), a leading sign, `inf` and `nan`. The whole
/// text must be the number. Correctly rounded; empty where the value overflows or is too small for a double.
std::optional<double> parse_number(std::string_view text);

/// Reads a whole number in the range of int64, also when written as `1e4` or `0x1p3`.
std::optional<std::int64_t> parse_integer(std::string_view text);

/// The whole number that `value` is, where it is one in the range of int64.
std::optional<std::int64_t> whole(double value);

/// The shortest decimal that reads back to `value` (std::to_chars); `inf`, `-inf`, `nan` otherwise.
std::string shortest(double value);

}  // namespace bezierbench::suite
