// SPDX-License-Identifier: MIT
// What is known of the terminal behind a standard stream: its width, and whether colours are wanted there; and text in
// lines of that width. Data files and CSV depend on neither.
#pragma once

#include <fmt/color.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

namespace bezierbench {

inline std::string_view environment_text(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

/// The width in characters: $COLUMNS where that is a number above 0, else that of the terminal behind `stream`. Empty
/// where there is no terminal, as in a pipe, so that other programs get one row per line.
inline std::optional<std::size_t> terminal_width(int stream) {
  const auto text = environment_text("COLUMNS");
  std::size_t columns = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), columns);
  if (error == std::errc() && end == text.data() + text.size() && columns > 0) return columns;
  winsize size{};
  if (isatty(stream) == 0 || ioctl(stream, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

/// The number of characters of a UTF-8 text.
inline std::size_t length_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

/// `head` and `text` in lines of at most `width` characters, cut at spaces. The first line begins with `head`, the
/// others with `indent` spaces. A longer word has a line of its own. An interval such as [0, 1] is one word, and so is
/// a command `in backquotes`, which could not be pasted from two lines.
inline std::string wrapped(std::string_view head, std::string_view text, std::size_t indent, std::size_t width) {
  std::string all;
  std::string line(head);
  bool has_word = false;
  while (!text.empty()) {
    const char last = text.front() == '[' ? ']' : '`';
    const auto closing = text.front() == '[' || text.front() == '`' ? text.find(last, 1) : 0;
    const auto word = text.substr(0, text.find(' ', closing == std::string_view::npos ? 0 : closing));
    if (has_word && length_of(line) + 1 + length_of(word) > width) {
      line.erase(line.find_last_not_of(' ') + 1);
      all += line + '\n';
      line = std::string(indent, ' ');
      has_word = false;
    }
    line += (has_word ? " " : "") + std::string(word);
    has_word = true;
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return all + line + '\n';
}

/// Whether `stream` is a terminal that shows colours and nobody forbids them (no-color.org).
inline bool has_colours(int stream) {
  return isatty(stream) != 0 && environment_text("NO_COLOR").empty() && environment_text("TERM") != "dumb";
}

/// `text` in this style where `stream` has colours.
inline std::string styled(int stream, const fmt::text_style& style, std::string_view text) {
  return has_colours(stream) ? fmt::format(style, "{}", text) : std::string(text);
}

}  // namespace bezierbench
