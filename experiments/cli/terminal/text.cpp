// SPDX-License-Identifier: MIT
#include "experiments/cli/terminal/text.hpp"

#include <errno.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "experiments/run/progress.hpp"
#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"

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

namespace {

constexpr std::size_t gap = 2;           // between columns
constexpr std::size_t least_text = 30;   // characters of a column of broken lines
constexpr std::size_t indent_below = 4;  // of fields below their row

using Fields = std::vector<std::string>;

struct Layout {
  std::size_t aligned = 0;  ///< so many columns stand side by side
  std::vector<std::size_t> widths;
  std::size_t last_width = 0;  ///< of the last of them, which is broken at spaces
};

Layout layout_of(const std::vector<Fields>& lines, std::size_t width) {
  Layout layout;
  layout.widths.resize(lines.front().size(), 0);
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) layout.widths[k] = std::max(layout.widths[k], length_of(line[k]));
  std::size_t used = 0;
  for (const auto column : layout.widths) {
    const bool is_last = layout.aligned + 1 == layout.widths.size();
    const bool fits = used + column <= width;
    if (!fits && layout.aligned > 0 && !(is_last && used + least_text <= width)) break;
    layout.last_width = fits ? column : width - std::min(width, used);
    used += column + gap;
    ++layout.aligned;
  }
  return layout;
}

std::string aligned_row(const Fields& line, const Layout& layout) {
  std::string out;
  std::size_t used = 0;
  for (std::size_t k = 0; k + 1 < layout.aligned; ++k) {
    out += padded(line[k], layout.widths[k] + gap);
    used += layout.widths[k] + gap;
  }
  bool first = true;
  std::string text;
  for (const auto& part : lines_of(line[layout.aligned - 1], layout.last_width)) {
    out += (first ? "" : std::string(used, ' ')) + part;
    out.erase(out.find_last_not_of(' ') + 1);
    text += out + '\n';
    out.clear();
    first = false;
  }
  return text;
}

/// The fields from column `first` on, with the names of their columns where these are several.
std::string fields_below(const Fields& header, const Fields& line, std::size_t first) {
  if (first + 1 == header.size()) return line[first];
  std::string text;
  for (auto k = first; k < header.size(); ++k)
    if (!line[k].empty()) text += (text.empty() ? "" : "; ") + header[k] + ' ' + line[k];
  return text;
}

}  // namespace

std::string fitted(std::vector<Fields> lines, std::optional<std::size_t> width) {
  for (auto& line : lines)
    for (auto& field : line) field = printable(field);
  const auto& header = lines.front();
  const auto most = width.value_or(SIZE_MAX);
  const auto layout = layout_of(lines, most);
  auto head = aligned_row(header, layout);
  head.pop_back();
  std::string text = styled(STDOUT_FILENO, fmt::emphasis::bold, head) + '\n';
  for (std::size_t row = 1; row < lines.size(); ++row) {
    text += aligned_row(lines[row], layout);
    if (const auto rest = fields_below(header, lines[row], layout.aligned); !rest.empty())
      text += wrapped(std::string(indent_below, ' '), rest, indent_below, most);
  }
  return text;
}

std::string shell_word(const std::string& text) {
  constexpr const char* plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789%+,-./:=@_";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + '\'';
}

std::string this_program() { return shell_word(program_invocation_name); }

void say(const std::string& text) {
  constexpr std::size_t longest = 1000;  // in bytes; an option may have megabytes
  run::note(shortened(std::string_view(text).substr(0, text.find_last_not_of(" \n") + 1), longest), "bezierbench: ");
}

Exit say_findings(std::span<const std::string> findings) {
  for (const auto& finding : findings) say(finding);
  return findings.empty() ? Exit::fine : Exit::finding;
}

}  // namespace bezierbench::cli
