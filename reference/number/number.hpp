// SPDX-License-Identifier: MIT
// Numbers as text, for every data file and option. The locale has no effect.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bezierbench::number {

/// The shortest decimal that reads back to the same bits; `inf`, `-inf`, `nan` (a NaN's sign and payload are dropped).
[[nodiscard]] std::string decimal(double value);

/// Hexadecimal floating point exactly as C's printf("%a") of glibc writes it, in any locale; non-finite as decimal().
[[nodiscard]] std::string hexadecimal(double value);

/// Reads what decimal() and hexadecimal() write, with an optional sign: the whole of `text` or nothing, no blanks.
/// Rounds to nearest, ties to even. nullopt for anything else, and for a magnitude that overflows to infinity or
/// underflows to zero (1e400, 1e-400).
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// Reads a whole number in the range of int64, also when written as `1e4` or `0x1p3`.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);

/// `value` as an integer, where it is one in the range of int64.
[[nodiscard]] std::optional<std::int64_t> whole(double value);

/// Why `text`, which parse_number() refuses or reads as infinity or NaN, is not a finite double, and what to do: the
/// predicate of a sentence.
[[nodiscard]] std::string_view fault(std::string_view text);

}  // namespace bezierbench::number
