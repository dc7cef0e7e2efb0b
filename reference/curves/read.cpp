// SPDX-License-Identifier: MIT
#include "reference/curves/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "reference/curves/csv.hpp"
#include "reference/curves/font.hpp"
#include "reference/curves/json.hpp"
#include "reference/curves/path_data.hpp"
#include "reference/curves/svg.hpp"

namespace bezierbench::curves {
namespace {

enum class Kind { csv, svg, json, path_data, font };

std::optional<Kind> kind_of_name(const std::string& name) {
  auto extension = std::filesystem::path(name).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  if (extension == ".csv") return Kind::csv;
  if (extension == ".svg") return Kind::svg;
  if (extension == ".json") return Kind::json;
  if (extension == ".txt") return Kind::path_data;
  constexpr std::array fonts{".ttf", ".otf", ".ttc", ".woff", ".woff2"};
  if (std::ranges::find(fonts, extension) != fonts.end()) return Kind::font;
  return std::nullopt;
}

bool is_font(std::string_view contents) {
  using namespace std::string_view_literals;
  constexpr std::array tags{"\0\1\0\0"sv, "OTTO"sv, "true"sv, "ttcf"sv, "wOFF"sv, "wOF2"sv};
  return std::ranges::any_of(tags, [&](auto tag) { return contents.starts_with(tag); });
}

/// A header of CSV begins with a letter, too; path data have a number next.
Kind kind_of(std::string_view contents) {
  const auto begin = contents.find_first_not_of(" \t\r\n\f\xEF\xBB\xBF");
  if (begin == std::string_view::npos) return Kind::csv;
  if (is_font(contents)) return Kind::font;
  const char first = contents[begin];
  if (first == '<') return Kind::svg;
  if (first == '[' || first == '{') return Kind::json;
  const auto next = contents.find_first_not_of(" \t\r\n\f", begin + 1);
  const bool number = next != std::string_view::npos &&
                      std::string_view("0123456789.+-").find(contents[next]) != std::string_view::npos;
  return (first == 'M' || first == 'm') && number ? Kind::path_data : Kind::csv;
}

}  // namespace

bool has_known_extension(const std::string& name) { return kind_of_name(name).has_value(); }

Read read(std::string_view contents, const std::string& name, const ReadOptions& options) {
  if (contents.size() > most_bytes)
    throw Unreadable(
        fmt::format("{}: has more than {} bytes, which are the most that are read; split the file", name, most_bytes));
  switch (kind_of_name(name).value_or(kind_of(contents))) {
    case Kind::svg: return read_svg(contents, name);
    case Kind::json: return read_json(contents, name, options.form);
    case Kind::font: return read_font(contents, name);
    case Kind::path_data: return read_path_data(contents, name);
    default: return read_csv(contents, name, options.form);
  }
}

}  // namespace bezierbench::curves
