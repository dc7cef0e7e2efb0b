// SPDX-License-Identifier: MIT
#include "experiments/cli/terminal/text.hpp"

#include <errno.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string_view>

#include "experiments/run/progress.hpp"
#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {

std::size_t output_width() { return terminal_width(STDOUT_FILENO).value_or(SIZE_MAX); }

std::size_t reading_width() {
  constexpr std::size_t usual = 80;
  constexpr std::size_t most_readable = 100;  // longer lines of text are hard to read
  return std::min(terminal_width(STDOUT_FILENO).value_or(usual), most_readable);
}

std::string padded(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(width - std::min(width, length_of(text)), ' ');
}

std::string wrapped(std::string_view head, std::string_view text, std::size_t indent) {
  return wrapped(head, text, indent, output_width());
}

std::vector<std::string> lines_of(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  const auto all = wrapped("", text, 0, width);
  for (std::size_t at = 0; at < all.size(); at = all.find('\n', at) + 1) {
    auto line = all.substr(at, all.find('\n', at) - at);
    for (; width > 0 && length_of(line) > width; line.erase(0, width)) lines.push_back(line.substr(0, width));
    lines.push_back(line);
  }
  return lines;
}

namespace {

constexpr std::size_t gap = 2;            // between columns
constexpr std::size_t least_text = 16;    // characters of a column of broken lines
constexpr std::size_t short_enough = 24;  // for a column not to be broken, and for ids
constexpr std::size_t indent_below = 4;   // of fields below their row

using Fields = std::vector<std::string>;

std::size_t sum_with_gaps(const std::vector<std::size_t>& widths, std::size_t columns) {
  return std::accumulate(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(columns), gap * columns) - gap;
}

/// The widths of the columns that stand side by side: those of their fields where these fit, else the widest columns
/// are narrowed. Fewer than there are columns where that does not suffice.
std::vector<std::size_t> widths_of(const std::vector<Fields>& lines, std::size_t width) {
  std::vector<std::size_t> natural(lines.front().size(), 0);
  std::vector<std::size_t> least(natural.size(), 0);
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) {
      natural[k] = std::max(natural[k], length_of(line[k]));
      for (const auto& word : lines_of(line[k], 0)) least[k] = std::max(least[k], length_of(word));
    }
  for (std::size_t k = 0; k < least.size(); ++k)
    least[k] = natural[k] <= short_enough ? natural[k] : k == 0 ? short_enough : std::max(least[k], least_text);
  std::size_t columns = natural.size();
  while (columns > 1 && sum_with_gaps(least, columns) > width) --columns;
  auto widths = natural;
  for (auto most = *std::ranges::max_element(natural); most > 0 && sum_with_gaps(widths, columns) > width; --most)
    for (std::size_t k = 0; k < columns; ++k) widths[k] = std::clamp(std::min(natural[k], most), least[k], natural[k]);
  widths.resize(columns);
  return widths;
}

/// A row in as many lines as its longest field needs; a first field that is too long has a line of its own.
std::string aligned_row(const Fields& line, const std::vector<std::size_t>& widths) {
  std::vector<std::vector<std::string>> parts;
  std::size_t height = 1;
  std::string text;
  for (std::size_t k = 0; k < widths.size(); ++k) {
    const bool has_own_line = k == 0 && widths.size() > 1 && length_of(line[k]) > widths[k];
    if (has_own_line) text = line[k] + '\n';
    parts.push_back(lines_of(has_own_line ? "" : line[k], widths[k]));
    height = std::max(height, parts.back().size());
  }
  for (std::size_t row = 0; row < height; ++row) {
    std::string out;
    for (std::size_t k = 0; k < widths.size(); ++k)
      out += padded(row < parts[k].size() ? parts[k][row] : "", widths[k] + gap);
    out.erase(out.find_last_not_of(' ') + 1);
    text += out + '\n';
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

std::string fitted(std::vector<Fields> lines, std::optional<std::size_t> width, std::size_t optional) {
  for (auto& line : lines)
    for (auto& field : line) field = printable(field);
  const auto most = width.value_or(SIZE_MAX);
  const auto natural = widths_of(lines, SIZE_MAX);
  for (auto columns = natural.size(); optional > 0 && sum_with_gaps(natural, columns) > most; --optional) {
    --columns;
    for (auto& line : lines) line.pop_back();
  }
  const auto& header = lines.front();
  const auto widths = widths_of(lines, most);
  auto head = aligned_row(header, widths);
  head.pop_back();
  std::string text = styled(STDOUT_FILENO, fmt::emphasis::bold, head) + '\n';
  for (std::size_t row = 1; row < lines.size(); ++row) {
    text += aligned_row(lines[row], widths);
    if (const auto rest = fields_below(header, lines[row], widths.size()); !rest.empty())
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
