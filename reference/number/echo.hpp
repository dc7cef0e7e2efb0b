// SPDX-License-Identifier: MIT
// Text from a file, a file name or the command line, made safe for a terminal: it cannot move the cursor, end the line
// or fill the screen. Data files are not written through this.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace bezierbench {
/// Whether the byte is a control character of ASCII.
inline bool is_control(char byte) { return static_cast<unsigned char>(byte) < 0x20 || byte == 0x7f; }

/// `text` with every control character as \xNN.
inline std::string printable(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string shown;
  for (const char byte : text) {
    if (is_control(byte)) {
      const auto value = static_cast<unsigned char>(byte);
      shown += {'\\', 'x', digits[value >> 4U], digits[value & 0xfU]};
    } else {
      shown += byte;
    }
  }
  return shown;
}

/// The place of the first control character except for tabs and line ends; npos where there is none.
inline std::size_t first_unprintable(std::string_view text) {
  const auto found =
      std::ranges::find_if(text, [](char c) { return is_control(c) && c != '\t' && c != '\n' && c != '\r'; });
  return found == text.end() ? std::string_view::npos : static_cast<std::size_t>(found - text.begin());
}

/// printable(text); where `text` has more than `most` bytes, its beginning and end with the number of bytes left out.
inline std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return printable(text);
  const auto is_inner = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U; };
  std::size_t head = most - most / 3;
  std::size_t tail = text.size() - most / 3;
  while (head > 0 && is_inner(head)) --head;
  while (tail < text.size() && is_inner(tail)) ++tail;
  return printable(text.substr(0, head)) + " ... " + std::to_string(tail - head) + " bytes ... " +
         printable(text.substr(tail));
}

/// A word or field of a file, or the value of an option, within a message.
inline std::string echo(std::string_view text) {
  constexpr std::size_t enough_to_find_it = 80;
  return shortened(text, enough_to_find_it);
}

}  // namespace bezierbench
