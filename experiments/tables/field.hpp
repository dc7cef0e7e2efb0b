// SPDX-License-Identifier: MIT
// A field of a row, as a study gives it. Text is made of it once, when the table is written.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace bezierbench::tables {

/// A number that is written in hexadecimal floating point, which keeps all bits.
struct Hexadecimal {
  double value;
  friend auto operator<=>(const Hexadecimal&, const Hexadecimal&) = default;
};

/// Nothing, a text, or a number.
using Field = std::variant<std::monostate, std::string, double, std::int64_t, Hexadecimal>;

/// The field of a text, a number, an optional one, or a field itself. No number and the empty text give the empty field.
template <class Value>
Field field(const Value& value) {
  if constexpr (std::convertible_to<const Value&, std::string_view>) {
    const std::string_view text = value;
    return text.empty() ? Field() : Field(std::string(text));
  } else if constexpr (std::integral<Value>) {
    return static_cast<std::int64_t>(value);
  } else if constexpr (std::floating_point<Value>) {
    return static_cast<double>(value);
  } else if constexpr (requires { value.has_value(); }) {
    return value ? field(*value) : Field();
  } else {
    return value;
  }
}

/// The field as it stands in a file: doubles as the shortest decimals that give them back.
std::string text(const Field& field);

}  // namespace bezierbench::tables
