// SPDX-License-Identifier: MIT
// TrueType outlines: the tables `glyf` and `loca`.
// Source: OpenType specification 1.9, chapters "glyf", "loca" and "hmtx".
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "reference/curves/outline.hpp"

namespace bezierbench::curves {

/// Draws glyphs exactly: implied points are halves, transforms are products of doubles. A glyph is shifted so that its
/// left side bearing is that of `hmtx`; its components are not.
class Glyf {
 public:
  /// The bytes of the tables; they must outlive the object. Throws Malformed.
  struct Tables {
    std::string_view head, maxp, hhea, hmtx, glyf, loca;
  };
  explicit Glyf(const Tables& tables);

  [[nodiscard]] std::size_t glyph_count() const { return glyph_count_; }
  /// Throws Malformed.
  void draw(std::size_t glyph, Outline& outline) const;

 private:
  struct Point {
    Coordinates at;
    bool is_on_curve;
    bool ends_contour;
  };
  using Points = std::vector<Point>;
  struct Component;

  [[nodiscard]] std::string_view data(std::size_t glyph) const;
  [[nodiscard]] double left_side_bearing(std::size_t glyph) const;
  [[nodiscard]] Points points(std::size_t glyph, int depth, Outline& outline) const;
  [[nodiscard]] Points composite_points(std::string_view description, int depth, Outline& outline) const;

  Tables tables_;
  std::size_t glyph_count_;
  std::size_t offset_bytes_;  ///< of an entry of `loca`
  std::size_t long_metrics_;
};

}  // namespace bezierbench::curves
