// SPDX-License-Identifier: MIT
// Text from a file, a file name or the command line, made safe for a terminal: it cannot move the cursor, end the line,
// change the direction of writing or fill the screen. Data files are not written through this.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace bezierbench {
namespace echo_detail {

/// The length of the UTF-8 sequence that `text` begins with, and its code point; length 0 where it is none.
struct Character {
  std::size_t length;
  std::uint32_t code;
};

inline Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[k])); };
  if (byte(0) < 0x80) return {1, byte(0)};
  const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length) return {0, 0};
  std::uint32_t code = byte(0) & (0x7fU >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xc0U) != 0x80U) return {0, 0};
    code = code << 6U | (byte(k) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};  // of so many bytes
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < least.at(length) || code > 0x10ffff || surrogate ? Character{0, 0} : Character{length, code};
}

/// True for control characters and those that end lines or change the direction of writing.
inline bool acts_on_terminal(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x61c || (code >= 0x200b && code <= 0x200f) ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2060 && code <= 0x206f) || code == 0xfeff ||
         (code >= 0xfff9 && code <= 0xfffb) || (code >= 0xe0000 && code <= 0xe007f);
}

}  // namespace echo_detail

/// `text` with every byte of such characters, and every byte that is not UTF-8, as \xNN.
inline std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const auto [length, code] = echo_detail::first_character(text);
    const bool harmless = length > 0 && !echo_detail::acts_on_terminal(code);
    const auto bytes = text.substr(0, length > 0 ? length : 1);
    for (const char byte : bytes) {
      if (harmless) {
        shown += byte;
        continue;
      }
      constexpr std::string_view digits = "0123456789abcdef";
      const auto value = static_cast<unsigned char>(byte);
      shown += "\\x";
      shown += digits[value >> 4U];
      shown += digits[value & 0xfU];
    }
    text.remove_prefix(bytes.size());
  }
  return shown;
}

/// The place of the first character that printable() changes, but for tabs and line ends; npos where there is none.
inline std::size_t first_unprintable(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto [length, code] = echo_detail::first_character(text.substr(at));
    const bool ends_line = code == '\t' || code == '\n' || code == '\r';
    if (length == 0 || (echo_detail::acts_on_terminal(code) && !ends_line)) return at;
    at += length;
  }
  return std::string_view::npos;
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
