// SPDX-License-Identifier: MIT
// The tables of fonts: their bytes, outlines of TrueType and of Type 2 charstrings, and the curves that these become.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "reference/curves/read.hpp"

namespace bezierbench::curves {

/// What is wrong with a table or a glyph, without the file: read_font names it.
class Malformed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of `table` from `begin`. Throws Malformed where the table is shorter.
inline std::string_view bytes_from(std::string_view table, std::size_t begin) {
  if (begin > table.size()) throw Malformed("an offset is beyond the end of its table");
  return table.substr(begin);
}

/// Reads numbers one after the other. Every function throws Malformed where bytes are missing.
class BigEndian {
 public:
  explicit BigEndian(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] bool empty() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }

  std::string_view take(std::size_t count) {
    if (count > rest_.size()) throw Malformed("its data end too early");
    const auto taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  /// An unsigned number of 1 to 4 bytes.
  std::uint32_t number(std::size_t bytes) {
    std::uint32_t value = 0;
    for (const char byte : take(bytes)) value = value << 8U | static_cast<unsigned char>(byte);
    return value;
  }

  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
  std::uint32_t u32() { return number(4); }
  std::int8_t i8() { return static_cast<std::int8_t>(number(1)); }
  std::int16_t i16() { return static_cast<std::int16_t>(number(2)); }
  std::int32_t i32() { return static_cast<std::int32_t>(number(4)); }

 private:
  std::string_view rest_;
};

// The contours of a font's glyphs become curves of a set.

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

// TrueType outlines: the tables `glyf` and `loca`.
// Source: OpenType specification 1.9, chapters "glyf", "loca" and "hmtx".

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

// Outlines of Type 2 charstrings: the tables `CFF ` and `CFF2`.
// Source: Adobe Technical Notes 5176 (The Compact Font Format Specification) and 5177 (The Type 2 Charstring Format);
// OpenType specification 1.9, chapter "CFF2".

/// Draws glyphs exactly: numbers are multiples of 2^-16, and so are their sums. The font matrix is not applied. Of a
/// variable font the default instance is drawn.
class Cff {
 public:
  /// `table` must outlive the object. Throws Malformed.
  Cff(std::string_view table, bool is_cff2);

  [[nodiscard]] std::size_t glyph_count() const { return charstrings_.size(); }
  /// Throws Malformed.
  void draw(std::size_t glyph, Outline& outline) const;

 private:
  /// Byte strings, by number.
  class Index {
   public:
    Index() = default;
    /// Reads an INDEX whose count has this many bytes, and moves past it.
    Index(BigEndian& from, std::size_t count_bytes);

    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] std::string_view operator[](std::size_t k) const;

   private:
    [[nodiscard]] std::size_t offset(std::size_t k) const;

    std::size_t count_ = 0;
    std::size_t offset_bytes_ = 1;
    std::string_view offsets_;
    std::string_view data_;
  };

  using Dict = std::map<int, std::vector<double>>;  ///< operands by operator; 12 x is 1200 + x

  /// What the glyphs of one font of a font share.
  struct Private {
    Index subroutines;
    std::size_t variations = 0;  ///< the set of regions at the start of a charstring
  };

  class Charstring;

  static Dict dict(std::string_view data);
  /// The bytes from the offset that a DICT states.
  [[nodiscard]] BigEndian from(const Dict& dict, int key, std::size_t operand = 0) const;
  [[nodiscard]] Private private_of(const Dict& dict) const;
  void read_font_of_glyph(BigEndian from);
  void read_regions(BigEndian from);
  void read_charset(const Dict& top);
  /// The glyph of a code of the standard encoding.
  [[nodiscard]] std::size_t standard_glyph(double code) const;

  std::string_view table_;
  bool is_cff2_;
  Index charstrings_;
  Index subroutines_;
  std::vector<Private> privates_;
  std::vector<std::uint16_t> font_of_glyph_;  ///< empty where there is one font
  std::vector<std::uint16_t> names_;          ///< the string identifiers of the glyphs, in CFF
  std::vector<std::size_t> regions_;          ///< how many regions each set of variations has, in CFF2
};

}  // namespace bezierbench::curves
