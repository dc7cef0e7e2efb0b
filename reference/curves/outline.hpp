// SPDX-License-Identifier: MIT
// The contours of a font's glyphs become curves of a set.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "reference/curves/read.hpp"

namespace bezierbench::curves {

struct Coordinates {
  double x = 0;
  double y = 0;
};

/// Draws glyphs into `read`: lines as degree 1, quadratics and cubics as degree 2 and 3, in font units. Every contour
/// is closed, by a line where it does not end at its start. Lines of zero length are left out and counted. The id of a
/// segment is `glyph:contour:segment`, numbered from 0. Throws Malformed beyond the limits.
class Outline {
 public:
  explicit Outline(Read& read) : read_(&read) {}

  /// Closes the glyph before. `id` is how the ids of its segments begin.
  void begin_glyph(std::string id);
  /// Closes the contour before.
  void move_to(Coordinates to);
  void line_to(Coordinates to);
  void quadratic_to(Coordinates control, Coordinates to);
  void cubic_to(Coordinates first, Coordinates second, Coordinates to);
  /// Closes the contour, if one is open.
  void close();

  [[nodiscard]] bool is_open() const { return is_open_; }

  /// Counts points, components and the operands and operators of charstrings, of all glyphs. A small file can state
  /// more of them than can ever be read.
  void spend(std::size_t steps);

 private:
  void add(std::span<const Coordinates> points);

  Read* read_;
  std::size_t* lines_left_out_ = nullptr;  ///< of `read`, from the first one
  std::string glyph_;
  Coordinates start_;
  Coordinates last_;
  std::size_t contours_ = 0;
  std::size_t segments_ = 0;  ///< of the open contour
  std::size_t steps_ = 0;
  bool is_open_ = false;
};

}  // namespace bezierbench::curves
