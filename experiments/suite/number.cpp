// SPDX-License-Identifier: MIT
#include "experiments/suite/number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace bezierbench::suite {
namespace {

template <class Number, class... Base>
std::optional<Number> from_all(std::string_view text, Base... base) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base...);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  // from_chars takes a minus of its own, `nan(...)`, and would read "inf" after 0x; none of them is a number here.
  if (text.starts_with('-') || text.find('(') != std::string_view::npos) return std::nullopt;
  if (hexadecimal && text.find_first_of("iInN") != std::string_view::npos) return std::nullopt;
  auto value = from_all<double>(text, hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (value && negative) value = -*value;
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  if (const auto value = from_all<std::int64_t>(text)) return value;
  const auto value = parse_number(text);
  return value ? whole(*value) : std::nullopt;
}

std::optional<std::int64_t> whole(double value) {
  if (!(value >= -0x1p63 && value < 0x1p63) || std::trunc(value) != value) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

std::string shortest(double value) {
  if (std::isnan(value)) return "nan";
  std::array<char, 64> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), written.ptr};
}

}  // namespace bezierbench::suite
