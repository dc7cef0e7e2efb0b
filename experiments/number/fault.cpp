// SPDX-License-Identifier: MIT
#include "experiments/number/fault.hpp"

#include <charconv>
#include <system_error>

namespace bezierbench::number {

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
