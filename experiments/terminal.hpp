// SPDX-License-Identifier: MIT
// What is known of the terminal behind a standard stream: its width, and whether colours are wanted there. Data files
// and CSV depend on neither.
#pragma once

#include <fmt/color.h>
#include <sys/ioctl.h>
#include <unistd.h>

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

/// Whether `stream` is a terminal that shows colours and nobody forbids them (no-color.org).
inline bool has_colours(int stream) {
  return isatty(stream) != 0 && environment_text("NO_COLOR").empty() && environment_text("TERM") != "dumb";
}

/// `text` in this style where `stream` has colours.
inline std::string styled(int stream, const fmt::text_style& style, std::string_view text) {
  return has_colours(stream) ? fmt::format(style, "{}", text) : std::string(text);
}

}  // namespace bezierbench
