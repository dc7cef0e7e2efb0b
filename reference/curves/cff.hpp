// SPDX-License-Identifier: MIT
// Outlines of Type 2 charstrings: the tables `CFF ` and `CFF2`.
// Source: Adobe Technical Notes 5176 (The Compact Font Format Specification) and 5177 (The Type 2 Charstring Format);
// OpenType specification 1.9, chapter "CFF2".
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "reference/curves/big_endian.hpp"
#include "reference/curves/outline.hpp"

namespace bezierbench::curves {

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
