// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "reference/curves/path_data.hpp"
#include "reference/curves/read.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::curves {
namespace {

constexpr std::string_view blanks = " \t\r\n\f";
constexpr std::size_t most_elements = most_curves;             // with those that `use` repeats
constexpr std::size_t most_repeated = std::size_t{64} << 20U;  // bytes of attributes that `use` repeats
constexpr std::size_t longest_id = 128;

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos ? std::string_view()
                                         : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// The name of an element without the prefix of its namespace.
std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.substr(name.find(':') + 1);
}

/// The part of `text` before `separator`, which is removed from it with the separator.
std::string_view take_part(std::string_view& text, char separator) {
  const auto part = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

struct DepthWalker : pugi::xml_tree_walker {
  bool for_each(pugi::xml_node& /*node*/) override { return depth() < most_nesting; }
};

class Document {
 public:
  Document(std::string_view text, const std::string& name) : source_{text, name} {
    constexpr std::string_view utf_16_le = "\xFF\xFE";
    constexpr std::string_view utf_16_be = "\xFE\xFF";
    constexpr std::string_view gzip = "\x1F\x8B";
    if (text.starts_with(utf_16_le) || text.starts_with(utf_16_be))
      source_.refuse(0, "is not in UTF-8; save it in UTF-8");
    if (text.starts_with(gzip)) source_.refuse(0, "is compressed; decompress it with gunzip");
    if (static_cast<std::size_t>(std::ranges::count(text, '<')) > 2 * most_elements)
      throw Unreadable(fmt::format("{}: more than {} elements; split the file", name, most_elements));
    // Line ends stay as they are, so that places in attributes are places of the file.
    const auto result = document_.load_buffer(text.data(), text.size(), pugi::parse_escapes, pugi::encoding_utf8);
    if (!result)
      source_.refuse(static_cast<std::size_t>(result.offset),
                     fmt::format("is not XML: {}; restore the file", lower_case(result.description())));
    DepthWalker walker;
    if (!document_.traverse(walker))
      throw Unreadable(fmt::format("{}: elements are nested more than {} deep; flatten the file", name, most_nesting));
  }

  Read read() {
    const auto root = document_.document_element();
    if (local_name(root) != "svg")
      source_.refuse(place_of(root), fmt::format("the outermost element is \"{}\", not svg; give an SVG file",
                                                 echo(std::string_view(root.name()))));
    collect_ids();
    draw(root, {}, 0, false);
    return std::move(read_);
  }

 private:
  static std::string lower_case(std::string text) {
    if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
    return text;
  }

  /// The tree is walked without recursion here, since only draw() limits its depth.
  void collect_ids() {
    struct : pugi::xml_tree_walker {
      bool for_each(pugi::xml_node& node) override {
        if (const auto id = node.attribute("id")) elements->emplace(id.value(), node);
        return true;
      }
      std::unordered_map<std::string_view, pugi::xml_node>* elements = nullptr;
    } walker;
    walker.elements = &elements_;
    document_.traverse(walker);
  }

  [[nodiscard]] std::size_t place_of(const pugi::xml_node& node) const {
    return std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)), source_.text.size());
  }

  /// The byte at which the value of an attribute begins in the text, or its element where that is not found.
  [[nodiscard]] std::size_t place_of(const pugi::xml_node& node, std::string_view attribute) const {
    const auto element = place_of(node);
    const auto text = source_.text;
    for (auto at = text.find_first_of("\"'>", element); at != std::string_view::npos && text[at] != '>';) {
      const auto name = trimmed(text.substr(element, at - element));
      const auto before = trimmed(name.substr(0, name.rfind('=')));
      if (before.ends_with(attribute) &&
          blanks.find(before[before.size() - attribute.size() - 1]) != std::string_view::npos)
        return at + 1;
      const auto end = text.find(text[at], at + 1);
      if (end == std::string_view::npos) break;
      at = text.find_first_of("\"'>", end + 1);
    }
    return element;
  }

  /// The value of an attribute; empty where it is missing. Throws Unreadable where `use` repeats too much.
  std::string_view value_of(const pugi::xml_node& node, const char* attribute) {
    const std::string_view value = node.attribute(attribute).value();
    bytes_ += value.size();
    if (bytes_ > 2 * source_.text.size() + most_repeated)
      throw Unreadable(fmt::format("{}: use elements repeat more than {} bytes of attributes; remove some",
                                   source_.name, most_repeated));
    return value;
  }

  /// The value of a property in the attribute `style`; the last one counts.
  std::optional<std::string_view> style_of(const pugi::xml_node& node, std::string_view property) {
    std::optional<std::string_view> value;
    for (auto rest = value_of(node, "style"); !rest.empty();) {
      auto after = take_part(rest, ';');
      if (trimmed(take_part(after, ':')) == property) value = trimmed(after.substr(0, after.find('!')));
    }
    return value;
  }

  bool is_displayed(const pugi::xml_node& node) {
    return style_of(node, "display").value_or(trimmed(value_of(node, "display"))) != "none";
  }

  [[noreturn]] void refuse(const pugi::xml_node& node, const char* attribute, std::string_view what) const {
    source_.refuse(place_of(node, attribute), what);
  }

  void leave_out(const std::string& what) { ++read_.left_out[what]; }

  /// A length in px; `otherwise` where the attribute is missing. nullopt for one in other units, which depend on the
  /// viewport or a font.
  std::optional<double> length(const pugi::xml_node& node, const char* attribute, double otherwise) {
    const auto text = trimmed(value_of(node, attribute));
    if (text.empty()) return otherwise;
    auto end = text.size();
    while (end > 0 && (text[end - 1] == '%' || (text[end - 1] >= 'A' && text[end - 1] <= 'z'))) --end;
    const auto word = text.substr(0, end);
    const auto value = number::parse_number(word);
    if (!value || !std::isfinite(*value))
      refuse(node, attribute, fmt::format("{}=\"{}\" {}", attribute, echo(text), number::fault(word)));
    struct Unit {
      std::string_view name;
      double px;
    };
    constexpr std::array<Unit, 7> units{
        {{"", 1}, {"px", 1}, {"in", 96}, {"cm", 96 / 2.54}, {"mm", 9.6 / 2.54}, {"pt", 96.0 / 72}, {"pc", 16}}};
    const auto* const unit = std::ranges::find(units, text.substr(end), &Unit::name);
    return unit == units.end() ? std::nullopt : std::optional(*value * unit->px);
  }

  /// The numbers of attributes that are lengths. nullopt, and counted, where one is in units that are unknown here.
  template <std::size_t n>
  std::optional<std::array<double, n>> lengths(const pugi::xml_node& node,
                                               const std::array<const char*, n>& attributes) {
    std::array<double, n> values{};
    for (std::size_t k = 0; k < n; ++k) {
      const auto value = length(node, attributes[k], 0);
      if (!value) {
        leave_out("shapes with a length in % or in units of a font");
        return std::nullopt;
      }
      values[k] = *value;
    }
    return values;
  }

  /// The map of the attribute `transform`.
  Affine transform_of(const pugi::xml_node& node) {
    const auto text = value_of(node, "transform");
    Affine all;
    if (trimmed(text) == "none") return all;
    const auto begin = text.empty() ? 0 : place_of(node, "transform");
    for (std::size_t at = 0; (at = text.find_first_not_of(" \t\r\n\f,", at)) != std::string_view::npos;) {
      const auto open = text.find('(', at);
      const auto close = text.find(')', at);
      if (open == std::string_view::npos || close == std::string_view::npos || close < open)
        source_.refuse(begin + at, "the transform has no pair of parentheses here; write, for example, translate(1,2)");
      const auto numbers = numbers_of(text.substr(open + 1, close - open - 1), source_, begin + open + 1);
      const auto one = function(trimmed(text.substr(at, open - at)), numbers);
      if (!one)
        source_.refuse(begin + at, fmt::format("\"{}\" is not a transform of SVG; write matrix, translate, scale, "
                                               "rotate, skewX or skewY with its numbers",
                                               echo(text.substr(at, close + 1 - at))));
      all = all * *one;
      at = close + 1;
    }
    return all;
  }
  static std::optional<Affine> function(std::string_view name, const std::vector<double>& v) {
    const auto given = [&](std::string_view wanted, std::initializer_list<std::size_t> counts) {
      return name == wanted && std::ranges::find(counts, v.size()) != counts.end();
    };
    const auto tangent = [](double degrees) {
      return static_cast<double>(std::tan(degrees * (std::numbers::pi_v<long double> / 180)));
    };
    if (given("matrix", {6})) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
    if (given("translate", {1, 2})) return Affine{1, 0, 0, 1, v[0], v.size() > 1 ? v[1] : 0};
    if (given("scale", {1, 2})) return Affine{v[0], 0, 0, v.back(), 0, 0};
    if (given("skewX", {1})) return Affine{1, 0, tangent(v[0]), 1, 0, 0};
    if (given("skewY", {1})) return Affine{1, tangent(v[0]), 0, 1, 0, 0};
    if (!given("rotate", {1, 3})) return std::nullopt;
    const auto [cosine, sine] = direction_of(v[0]);
    const Affine turn{cosine, sine, -sine, cosine, 0, 0};
    return v.size() == 1 ? turn : Affine{1, 0, 0, 1, v[1], v[2]} * turn * Affine{1, 0, 0, 1, -v[1], -v[2]};
  }

  /// Draws an element and what is in it. `used` says that `use` names it.
  void draw(const pugi::xml_node& node, const Affine& outer, int depth, bool used) {  // NOLINT(misc-no-recursion)
    if (node.type() != pugi::node_element) return;
    if (depth > most_nesting)
      source_.refuse(place_of(node), fmt::format("nested more than {} deep with what use elements name, which may be "
                                                 "themselves; remove a use",
                                                 most_nesting));
    if (++elements_drawn_ > most_elements)
      throw Unreadable(fmt::format("{}: more than {} elements with what use elements repeat; remove some", source_.name,
                                   most_elements));
    const auto kind = local_name(node);
    if (!is_displayed(node)) return leave_out("elements with display:none");
    if (style_of(node, "transform")) leave_out("transforms in CSS");
    const auto map = outer * transform_of(node);
    if (kind == "g" || kind == "a" || kind == "svg" || kind == "switch" || (kind == "symbol" && used)) {
      const bool moved = kind == "svg" && depth > 0;
      const auto origin = moved ? lengths<2>(node, {"x", "y"}) : std::array<double, 2>{};
      if (!origin) return;
      for (const auto& child : node.children()) draw(child, moved ? map * shift(*origin) : map, depth + 1, false);
    } else if (kind == "use") {
      draw_used(node, map, depth);
    } else if (!draw_shape(node, kind, map)) {
      constexpr std::array silent{"title", "desc", "metadata", "style", "script", "namedview"};
      if (std::ranges::find(silent, kind) == silent.end()) leave_out(fmt::format("elements {}", echo(kind)));
    }
  }

  static Affine shift(const std::array<double, 2>& by) { return {1, 0, 0, 1, by[0], by[1]}; }

  void draw_used(const pugi::xml_node& node, const Affine& map, int depth) {  // NOLINT(misc-no-recursion)
    auto reference = node.attribute("href");
    if (!reference) reference = node.attribute("xlink:href");
    const auto href = trimmed(reference.value());
    const auto found = href.starts_with('#') ? elements_.find(href.substr(1)) : elements_.end();
    if (found == elements_.end()) return leave_out("use elements of what is not in the file");
    if (const auto by = lengths<2>(node, {"x", "y"})) draw(found->second, map * shift(*by), depth + 1, true);
  }

  /// The path of an element, named by its id or else by its number.
  Path path_of(const pugi::xml_node& node, const Affine& map) {
    std::string name = node.attribute("id").value();
    const bool fits = !name.empty() && name.size() <= longest_id && first_unprintable(name) == std::string_view::npos &&
                      name.find_first_of("\t\r\n") == std::string::npos;
    if (!fits || !names_.insert(name).second) {
      name = std::to_string(paths_);
      while (!names_.insert(name).second) name += '\'';
    }
    ++paths_;
    return {read_, std::move(name), map, source_.name};
  }

  /// Draws a path or a basic shape; false where the element is neither.
  bool draw_shape(const pugi::xml_node& node, std::string_view kind, const Affine& map) {
    if (kind == "path") {
      const auto data = value_of(node, "d");
      if (trimmed(data) == "none") return true;
      auto path = path_of(node, map);
      curves::draw(data, source_, place_of(node, "d"), path);
    } else if (kind == "rect") {
      if (const auto box = lengths<4>(node, {"x", "y", "width", "height"})) draw_rect(node, *box, map);
    } else if (kind == "circle") {
      if (const auto v = lengths<3>(node, {"cx", "cy", "r"}))
        draw_ellipse(node, {(*v)[0], (*v)[1]}, {(*v)[2], (*v)[2]}, map);
    } else if (kind == "ellipse") {
      const auto centre = lengths<2>(node, {"cx", "cy"});
      const auto radii = radii_of(node);
      if (centre && radii) draw_ellipse(node, *centre, *radii, map);
    } else if (kind == "line") {
      if (const auto v = lengths<4>(node, {"x1", "y1", "x2", "y2"})) {
        auto path = path_of(node, map);
        path.move_to({(*v)[0], (*v)[1]});
        path.line_to({(*v)[2], (*v)[3]});
      }
    } else if (kind == "polyline" || kind == "polygon") {
      draw_polygon(node, kind == "polygon", map);
    } else {
      return false;
    }
    return true;
  }

  /// The radii of a rect or an ellipse: one that is missing or `auto` is as the other one.
  std::optional<std::array<double, 2>> radii_of(const pugi::xml_node& node) {
    const auto is_given = [&](const char* name) {
      const auto text = trimmed(value_of(node, name));
      return !text.empty() && text != "auto";
    };
    const char* const rx = is_given("rx") ? "rx" : "ry";
    const char* const ry = is_given("ry") ? "ry" : "rx";
    if (!is_given(rx)) return std::array<double, 2>{};
    return lengths<2>(node, {rx, ry});
  }

  void draw_rect(const pugi::xml_node& node, const std::array<double, 4>& box, const Affine& map) {
    const auto [x, y, width, height] = box;
    auto radii = radii_of(node);
    if (!radii) return;
    if (!(width > 0) || !(height > 0)) return leave_out("shapes without an extent");
    const double rx = std::clamp((*radii)[0], 0.0, width / 2);
    const double ry = std::clamp((*radii)[1], 0.0, height / 2);
    const double right = x + width;
    const double bottom = y + height;
    auto path = path_of(node, map);
    if (rx == 0 || ry == 0) {
      path.move_to({x, y});
      for (const PlanePoint& corner : {PlanePoint{right, y}, {right, bottom}, {x, bottom}, {x, y}})
        path.line_to(corner);
      return;
    }
    path.move_to({x + rx, y});
    const auto corner = [&](const PlanePoint& from, const PlanePoint& control, const PlanePoint& to) {
      if (path.current() != from) path.line_to(from);
      path.conic_to(control, quarter_weight, to);
    };
    const double inner_right = rx == width / 2 ? x + rx : right - rx;  // where no line is between two corners
    const double inner_bottom = ry == height / 2 ? y + ry : bottom - ry;
    corner({inner_right, y}, {right, y}, {right, y + ry});
    corner({right, inner_bottom}, {right, bottom}, {inner_right, bottom});
    corner({x + rx, bottom}, {x, bottom}, {x, inner_bottom});
    corner({x, y + ry}, {x, y}, {x + rx, y});
  }

  void draw_ellipse(const pugi::xml_node& node, const PlanePoint& centre, const PlanePoint& radii, const Affine& map) {
    const auto [x, y] = centre;
    const auto [rx, ry] = radii;
    if (!(rx > 0) || !(ry > 0)) return leave_out("shapes without an extent");
    auto path = path_of(node, map);
    path.move_to({x + rx, y});
    path.conic_to({x + rx, y + ry}, quarter_weight, {x, y + ry});
    path.conic_to({x - rx, y + ry}, quarter_weight, {x - rx, y});
    path.conic_to({x - rx, y - ry}, quarter_weight, {x, y - ry});
    path.conic_to({x + rx, y - ry}, quarter_weight, {x + rx, y});
  }

  void draw_polygon(const pugi::xml_node& node, bool closed, const Affine& map) {
    const auto numbers = numbers_of(value_of(node, "points"), source_, place_of(node, "points"));
    if (numbers.size() % 2 != 0)
      refuse(node, "points", fmt::format("points has {} numbers; write two for each point", numbers.size()));
    if (numbers.empty()) return;
    auto path = path_of(node, map);
    path.move_to({numbers[0], numbers[1]});
    for (std::size_t k = 2; k < numbers.size(); k += 2) path.line_to({numbers[k], numbers[k + 1]});
    if (closed) path.close();
  }

  static constexpr double quarter_weight = std::numbers::sqrt2 / 2;

  Source source_;
  pugi::xml_document document_;
  Read read_;
  std::unordered_map<std::string_view, pugi::xml_node> elements_;  ///< by id; the first one counts
  std::unordered_set<std::string> names_;                          ///< of paths
  std::size_t paths_ = 0;
  std::size_t elements_drawn_ = 0;
  std::size_t bytes_ = 0;  ///< of the values of attributes that were read
};

}  // namespace

Read read_svg(std::string_view text, const std::string& name) { return Document(text, name).read(); }

}  // namespace bezierbench::curves
