// SPDX-License-Identifier: MIT
#include "reference/number/number.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <system_error>

namespace bezierbench::number {
namespace {

std::string non_finite(double value) { return std::isnan(value) ? "nan" : (value < 0 ? "-inf" : "inf"); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hex_digit(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

// from_chars accepts more than this function may: "infinity", "nan(...)" and a second minus. The first character must
// therefore be a digit, or a point before a digit.
bool starts_number(std::string_view text, bool (*digit)(char)) {
  if (text.starts_with('.')) text.remove_prefix(1);
  return !text.empty() && digit(text.front());
}

}  // namespace

std::string decimal(double value) {
  if (!std::isfinite(value)) return non_finite(value);
  std::array<char, 32> buffer;  // the longest is -2.2250738585072014e-308, 24 characters
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

std::string hexadecimal(double value) {
  if (!std::isfinite(value)) return non_finite(value);
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & 0xf'ffff'ffff'ffff;

  std::string text = std::signbit(value) ? "-0x" : "0x";
  if (biased == 0 && fraction == 0) return text + "0p+0";
  text += biased == 0 ? '0' : '1';  // glibc does not normalise subnormals: 0x0.xxxp-1022
  if (fraction != 0) {
    text += '.';
    for (int shift = 48; shift >= 0; shift -= 4) text += "0123456789abcdef"[(fraction >> shift) & 0xf];
    text.erase(text.find_last_not_of('0') + 1);
  }
  const int exponent = biased == 0 ? -1022 : biased - 1023;
  return text + (exponent < 0 ? "p-" : "p+") + std::to_string(std::abs(exponent));
}

std::optional<double> parse_number(std::string_view text) {
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text == "inf") {
    const double infinity = std::numeric_limits<double>::infinity();
    return negative ? -infinity : infinity;
  }

  const bool hex = text.starts_with("0x") || text.starts_with("0X");
  if (hex) text.remove_prefix(2);
  if (!starts_number(text, hex ? is_hex_digit : is_digit)) return std::nullopt;
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto format = hex ? std::chars_format::hex : std::chars_format::general;
  const auto [end, error] = std::from_chars(text.data(), last, value, format);
  if (error != std::errc{} || end != last) return std::nullopt;
  return negative ? -value : value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  std::int64_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error == std::errc{} && end == last) return value;
  const auto number = parse_number(text);
  return number ? whole(*number) : std::nullopt;
}

std::optional<std::int64_t> whole(double value) {
  if (!(value >= -0x1p63 && value < 0x1p63) || std::trunc(value) != value) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

std::string_view fault(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] =
      std::from_chars(text.data(), last, value, hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (error == std::errc::result_out_of_range && end == last) {
    const auto exponent = text.find_first_of(hexadecimal ? "pP" : "eE");
    const bool tiny = exponent == std::string_view::npos ? text.starts_with('0') || text.starts_with('.')
                                                         : text.substr(exponent + 1).starts_with('-');
    return tiny ? "is too small for a double; write 0, or scale all coordinates up"
                : "is too large for a double; scale all coordinates down";
  }
  if (text.find_first_of("()[]{}") != std::string_view::npos)
    return "is not a number; write numbers without brackets, separated by commas";
  return "is not a finite number; write a decimal or hexadecimal double";
}

}  // namespace bezierbench::number
