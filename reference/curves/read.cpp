// SPDX-License-Identifier: MIT
#include "reference/curves/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_set>

#include "reference/curves/csv.hpp"
#include "reference/curves/path_data.hpp"

namespace bezierbench::curves {
namespace {

enum class Kind { csv, svg, json, path_data, font, model };

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
  constexpr std::array models{".step", ".stp", ".iges", ".igs"};
  if (std::ranges::find(models, extension) != models.end()) return Kind::model;
  return std::nullopt;
}

bool is_font(std::string_view contents) {
  using namespace std::string_view_literals;
  constexpr std::array tags{"\0\1\0\0"sv, "OTTO"sv, "true"sv, "ttcf"sv, "wOFF"sv, "wOF2"sv};
  return std::ranges::any_of(tags, [&](auto tag) { return contents.starts_with(tag); });
}

/// STEP by its first word, IGES by the number of its first line, which begins in column 73.
bool is_model(std::string_view contents) {
  constexpr std::size_t card = 80;
  return contents.starts_with("ISO-10303-21;") ||
         (contents.size() > card && contents[72] == 'S' && contents[card - 1] == '1' &&
          contents.substr(73, 6).find_first_not_of(" 0") == std::string_view::npos);
}

/// A header of CSV begins with a letter, too; path data have a number next.
Kind kind_of(std::string_view contents) {
  const auto begin = contents.find_first_not_of(" \t\r\n\f\xEF\xBB\xBF");
  if (begin == std::string_view::npos) return Kind::csv;
  if (is_font(contents)) return Kind::font;
  if (is_model(contents)) return Kind::model;
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
    case Kind::model:
      if (options.model != nullptr) return options.model(contents, name);
      throw Unreadable(
          fmt::format("{}: STEP and IGES require Open CASCADE, which is not in this build; `scripts/build peers` makes "
                      "a program that has it, and its `curves --out` a CSV file for all others",
                      name));
    default: return read_csv(contents, name, options.form);
  }
}

void Source::refuse(std::size_t offset, std::string_view what) const {
  const auto before = text.substr(0, offset);
  const auto line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  throw Unreadable(
      fmt::format("{}:{}:{}: {}", name, 1 + std::ranges::count(before, '\n'), before.size() - line_begin + 1, what));
}

void require_room(const CurveSet& set, std::string_view name) {
  if (set.size() >= most_curves)
    throw Unreadable(fmt::format("{}: more than {} curves; split the file", name, most_curves));
}

namespace {

/// Whether the ids of all files do not suffice to tell their curves apart.
bool clash(std::span<const NamedRead> files) {
  std::unordered_set<std::string_view> ids;
  for (const auto& file : files)
    for (std::size_t k = 0; k < file.read.set.size(); ++k)
      if (const auto id = file.read.set.id(k); id.empty() || !ids.insert(id).second) return true;
  return false;
}

}  // namespace

Read joined(std::span<const NamedRead> files) {
  const bool prefixed = files.size() > 1 && clash(files);
  std::unordered_set<std::string> stems;
  Read all;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const auto& [name, read] = files[f];
    auto stem = std::filesystem::path(name).stem().string();
    for (int number = 2; !stems.insert(stem).second; ++number)
      stem = fmt::format("{}-{}", std::filesystem::path(name).stem().string(), number);
    for (std::size_t k = 0; k < read.set.size(); ++k) {
      require_room(all.set, name);
      const auto id = read.set.id(k);
      const auto unique = id.empty() ? stem : fmt::format("{}:{}", stem, id);
      all.set.add(prefixed ? unique : id, read.set[k], read.set.begins_path(k), read.set.parameters(k));
    }
    for (const auto& [why, count] : read.left_out) all.left_out[why] += count;
  }
  return all;
}

}  // namespace bezierbench::curves
