// SPDX-License-Identifier: MIT
#include "experiments/cli/terminal/wrapped.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdint>

#include "experiments/terminal.hpp"

namespace bezierbench::cli {

std::size_t length_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

std::size_t output_width() { return terminal_width(STDOUT_FILENO).value_or(SIZE_MAX); }

std::string padded(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(width - std::min(width, length_of(text)), ' ');
}

std::string wrapped(std::string_view head, std::string_view text, std::size_t indent, std::size_t width) {
  std::string all;
  std::string line(head);
  bool has_word = false;
  while (!text.empty()) {
    const auto word = text.substr(0, std::min(text.find(' '), text.size()));
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

std::vector<std::string> lines_of(std::string_view text, std::size_t width) {
  auto all = wrapped("", text, 0, width);
  std::vector<std::string> lines;
  for (std::size_t end = 0; !all.empty(); all.erase(0, end + 1)) lines.push_back(all.substr(0, end = all.find('\n')));
  return lines;
}

}  // namespace bezierbench::cli
