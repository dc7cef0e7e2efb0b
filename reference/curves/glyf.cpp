// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "reference/curves/font_tables.hpp"

namespace bezierbench::curves {
namespace {

constexpr std::size_t most_points = 65'535;  // of a glyph: `maxp` counts them in 16 bits

double f2dot14(BigEndian& from) { return from.i16() / 16384.0; }

Coordinates between(Coordinates a, Coordinates b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }

/// The flags of points, with the repeated ones written out.
std::vector<unsigned> point_flags(BigEndian& from, std::size_t count) {
  constexpr unsigned repeat = 8;
  std::vector<unsigned> flags;
  while (flags.size() < count) {
    const unsigned flag = from.u8();
    const std::size_t times = 1 + std::size_t{(flag & repeat) != 0 ? from.u8() : std::uint8_t{0}};
    if (times > count - flags.size()) throw Malformed("its flags are for more points than it has");
    flags.insert(flags.end(), times, flag);
  }
  return flags;
}

/// The distance of a coordinate from that of the point before: of one byte whose sign is the flag `same`, of two bytes,
/// or zero.
int delta(BigEndian& from, unsigned flags, unsigned is_short, unsigned same) {
  if ((flags & is_short) != 0) return (flags & same) != 0 ? from.u8() : -static_cast<int>(from.u8());
  return (flags & same) != 0 ? 0 : from.i16();
}

}  // namespace

/// A glyph that is part of another one.
struct Glyf::Component {
  explicit Component(BigEndian& from);

  void transform(Points& points) const;
  void place(Points& points, const Points& before) const;

  unsigned flags;
  std::size_t glyph;
  int first, second;  ///< an offset, or numbers of points that shall coincide
  double xx = 1, xy = 0, yx = 0, yy = 1;

  static constexpr unsigned are_words = 0x1, are_offsets = 0x2, has_scale = 0x8, more = 0x20, has_two_scales = 0x40,
                            has_matrix = 0x80, scaled_offset = 0x800, unscaled_offset = 0x1000;
};

Glyf::Component::Component(BigEndian& from) : flags(from.u16()), glyph(from.u16()) {
  const auto argument = [&]() -> int {
    if ((flags & are_offsets) != 0) return (flags & are_words) != 0 ? from.i16() : from.i8();
    return (flags & are_words) != 0 ? from.u16() : from.u8();
  };
  first = argument();
  second = argument();
  if ((flags & has_scale) != 0) {
    xx = yy = f2dot14(from);
  } else if ((flags & has_two_scales) != 0) {
    xx = f2dot14(from);
    yy = f2dot14(from);
  } else if ((flags & has_matrix) != 0) {
    xx = f2dot14(from);
    xy = f2dot14(from);
    yx = f2dot14(from);
    yy = f2dot14(from);
  }
}

void Glyf::Component::transform(Points& points) const {
  for (auto& [at, on, ends] : points) at = {at.x * xx + at.y * yx, at.x * xy + at.y * yy};
}

void Glyf::Component::place(Points& points, const Points& before) const {
  const auto move = [&](double x, double y) {
    for (auto& point : points) point.at = {point.at.x + x, point.at.y + y};
  };
  if ((flags & are_offsets) != 0 && (flags & (scaled_offset | unscaled_offset)) == scaled_offset) {
    move(first, second);
    transform(points);
  } else if ((flags & are_offsets) != 0) {
    transform(points);
    move(first, second);
  } else {
    transform(points);
    if (static_cast<std::size_t>(first) >= before.size() || static_cast<std::size_t>(second) >= points.size())
      throw Malformed(fmt::format("its component is attached to point {} or {}, which does not exist", first, second));
    const auto [x, y] = before[static_cast<std::size_t>(first)].at;
    const auto [own_x, own_y] = points[static_cast<std::size_t>(second)].at;
    move(x - own_x, y - own_y);
  }
}

Glyf::Glyf(const Tables& tables) : tables_(tables) {
  offset_bytes_ = BigEndian(bytes_from(tables.head, 50)).u16() == 0 ? 2 : 4;
  glyph_count_ = BigEndian(bytes_from(tables.maxp, 4)).u16();
  long_metrics_ = BigEndian(bytes_from(tables.hhea, 34)).u16();
}

std::string_view Glyf::data(std::size_t glyph) const {
  BigEndian offsets(bytes_from(tables_.loca, glyph * offset_bytes_));
  const std::size_t unit = offset_bytes_ == 2 ? 2 : 1;
  const std::size_t begin = offsets.number(offset_bytes_) * unit;
  std::size_t end = offsets.number(offset_bytes_) * unit;
  // FreeType 2.12 counts the end of the last glyph of a WOFF2 file from the beginning of the font.
  if (glyph + 1 == glyph_count_) end = std::min(end, tables_.glyf.size());
  if (begin > end || end > tables_.glyf.size()) throw Malformed("`loca` places it outside of `glyf`");
  return tables_.glyf.substr(begin, end - begin);
}

double Glyf::left_side_bearing(std::size_t glyph) const {
  const std::size_t at = glyph < long_metrics_ ? 4 * glyph + 2 : 4 * long_metrics_ + 2 * (glyph - long_metrics_);
  return BigEndian(bytes_from(tables_.hmtx, at)).i16();
}

void Glyf::draw(std::size_t glyph, Outline& outline) const {
  Points points = this->points(glyph, 0, outline);
  if (points.empty()) return;
  const double shift = left_side_bearing(glyph) - BigEndian(bytes_from(data(glyph), 2)).i16();
  for (auto& point : points) point.at.x += shift;
  for (auto begin = points.begin(); begin != points.end();) {
    auto end = begin;
    while (!end->ends_contour) ++end;
    ++end;
    const std::span contour(begin, end);
    begin = end;
    // A contour begins at its first point on the curve; without one, between its last point and its first.
    std::size_t first = 0;
    while (first < contour.size() && !contour[first].is_on_curve) ++first;
    const bool has_on_curve = first < contour.size();
    const Coordinates start = has_on_curve ? contour[first].at : between(contour.back().at, contour.front().at);
    outline.move_to(start);
    const Point* control = nullptr;
    const auto visit = [&](const Point& point) {
      if (point.is_on_curve && control == nullptr) outline.line_to(point.at);
      if (point.is_on_curve && control != nullptr) outline.quadratic_to(control->at, point.at);
      if (!point.is_on_curve && control != nullptr) outline.quadratic_to(control->at, between(control->at, point.at));
      control = point.is_on_curve ? nullptr : &point;
    };
    const std::size_t others = contour.size() - (has_on_curve ? 1 : 0);
    for (std::size_t k = 0; k < others; ++k) visit(contour[(first + (has_on_curve ? 1 : 0) + k) % contour.size()]);
    if (control != nullptr) outline.quadratic_to(control->at, start);
  }
  outline.close();
}

Glyf::Points Glyf::points(std::size_t glyph, int depth, Outline& outline) const {
  if (glyph >= glyph_count_) throw Malformed(fmt::format("its component {} does not exist", glyph));
  if (depth > most_nesting) throw Malformed(fmt::format("its components are nested more than {} deep", most_nesting));
  const auto description = data(glyph);
  outline.spend(8);  // a component without points takes as long as about so many operands
  if (description.empty()) return {};
  BigEndian from(description);
  const int contours = from.i16();
  from.take(8);  // its bounds
  if (contours < 0) return composite_points(from.rest(), depth, outline);

  Points points;
  for (int k = 0; k < contours; ++k) {
    const std::size_t end = from.u16() + std::size_t{1};
    if (end <= points.size() || end > most_points) throw Malformed("the ends of its contours do not increase");
    points.resize(end);
    points.back().ends_contour = true;
  }
  if (points.empty()) return points;
  outline.spend(points.size());
  from.take(from.u16());  // instructions
  const auto flags = point_flags(from, points.size());
  double x = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k].is_on_curve = (flags[k] & 1U) != 0;
    points[k].at.x = x += delta(from, flags[k], 0x2, 0x10);
  }
  double y = 0;
  for (std::size_t k = 0; k < points.size(); ++k) points[k].at.y = y += delta(from, flags[k], 0x4, 0x20);
  return points;
}

Glyf::Points Glyf::composite_points(std::string_view description, int depth, Outline& outline) const {
  Points all;
  BigEndian from(description);
  for (bool more = true; more;) {
    const Component component(from);
    Points points = this->points(component.glyph, depth + 1, outline);
    component.place(points, all);
    if (all.size() + points.size() > most_points)
      throw Malformed(fmt::format("it has more than {} points", most_points));
    outline.spend(points.size());
    all.insert(all.end(), points.begin(), points.end());
    more = (component.flags & Component::more) != 0;
  }
  return all;
}

}  // namespace bezierbench::curves
