// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <freetype/freetype.h>
#include <freetype/tttables.h>
#include <ft2build.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "reference/curves/font_tables.hpp"
#include "reference/curves/read.hpp"

namespace bezierbench::curves {
namespace {

constexpr std::size_t most_steps = 10 * most_curves;  // a second, about

bool coincide(Coordinates a, Coordinates b) { return a.x == b.x && a.y == b.y; }

}  // namespace

void Outline::begin_glyph(std::string id) {
  close();
  glyph_ = std::move(id);
  contours_ = 0;
}

void Outline::move_to(Coordinates to) {
  close();
  start_ = last_ = to;
  segments_ = 0;
  ++contours_;
  is_open_ = true;
}

void Outline::line_to(Coordinates to) {
  if (!coincide(last_, to)) return add(std::array{last_, to});
  if (lines_left_out_ == nullptr) lines_left_out_ = &read_->left_out["lines of zero length"];
  ++*lines_left_out_;
}

void Outline::quadratic_to(Coordinates control, Coordinates to) { add(std::array{last_, control, to}); }

void Outline::cubic_to(Coordinates first, Coordinates second, Coordinates to) {
  add(std::array{last_, first, second, to});
}

void Outline::close() {
  if (is_open_ && !coincide(last_, start_)) add(std::array{last_, start_});
  is_open_ = false;
}

void Outline::spend(std::size_t steps) {
  steps_ += steps;
  if (steps_ > most_steps) throw Malformed(fmt::format("its glyphs take more than {} steps", most_steps));
}

void Outline::add(std::span<const Coordinates> points) {
  if (read_->set.size() == most_curves) throw Malformed(fmt::format("the font has more than {} curves", most_curves));
  std::array<double, 8> numbers;
  std::size_t count = 0;
  for (const auto& [x, y] : points) {
    if (!std::isfinite(x) || !std::isfinite(y)) throw Malformed("a coordinate is too large");
    numbers[count++] = x + 0.0;  // no negative zeros
    numbers[count++] = y + 0.0;
  }
  read_->set.add(fmt::format("{}:{}:{}", glyph_, contours_ - 1, segments_),
                 {.degree = static_cast<int>(points.size()) - 1, .coefficients = std::span(numbers).first(count)},
                 segments_ == 0);
  ++segments_;
  last_ = points.back();
}

namespace {

constexpr FT_Long most_faces = 256;

struct Done {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using Library = std::unique_ptr<FT_LibraryRec_, Done>;
using Face = std::unique_ptr<FT_FaceRec_, Done>;

Library library() {
  FT_Library made = nullptr;
  if (const FT_Error error = FT_Init_FreeType(&made); error != 0)
    throw Malformed(fmt::format("FreeType does not start (its error {})", error));
  return Library(made);
}

Face open(const Library& library, std::string_view contents, FT_Long number) {
  FT_Face face = nullptr;
  const auto* bytes = reinterpret_cast<const FT_Byte*>(contents.data());
  const auto error = FT_New_Memory_Face(library.get(), bytes, static_cast<FT_Long>(contents.size()), number, &face);
  if (error != 0) throw Malformed(fmt::format("FreeType does not open it (its error {})", error));
  return Face(face);
}

/// What FreeType would allocate for the tables of a compressed font, which its header states.
void check_container(std::string_view contents) {
  using namespace std::string_view_literals;
  static constexpr std::array kinds{"\0\1\0\0"sv, "true"sv, "OTTO"sv, "ttcf"sv, "wOFF"sv, "wOF2"sv};
  const auto kind = contents.substr(0, 4);
  if (std::ranges::find(kinds, kind) == kinds.end()) throw Malformed("it is not a font of TrueType or OpenType");
  if ((kind == "wOFF" || kind == "wOF2") && BigEndian(bytes_from(contents, 16)).u32() > most_bytes)
    throw Malformed(fmt::format("its tables have more than {} bytes", most_bytes));
}

/// The names of the glyphs; a glyph without a name of its own, or with one that would break an id, has its number.
class GlyphNames {
 public:
  explicit GlyphNames(FT_Face face) : face_(face) {}

  std::string operator()(std::size_t glyph) {
    std::array<char, 128> buffer{};
    if (FT_HAS_GLYPH_NAMES(face_) &&
        FT_Get_Glyph_Name(face_, static_cast<FT_UInt>(glyph), buffer.data(), buffer.size()) == 0) {
      std::string name = buffer.data();
      const auto breaks = [](char c) { return c <= ' ' || c > '~' || c == ',' || c == ':' || c == '"'; };
      if (!name.empty() && std::ranges::none_of(name, breaks) && taken_.insert(name).second) return name;
    }
    auto number = fmt::format("{}", glyph);
    while (!taken_.insert(number).second) number += '\'';  // a glyph may have a number as its name
    return number;
  }

 private:
  FT_Face face_;
  std::set<std::string> taken_;
};

class Reader {
 public:
  Read read(std::string_view contents) {
    check_container(contents);
    const Library library = curves::library();
    Face face = open(library, contents, 0);
    const FT_Long faces = face->num_faces;
    if (faces > most_faces) throw Malformed(fmt::format("it has more than {} faces", most_faces));
    for (FT_Long number = 0; number < faces; ++number) {
      if (number > 0) face = open(library, contents, number);
      read_face(face.get(), faces > 1 ? fmt::format("{}:", number) : "");
    }
    return std::move(read_);
  }

 private:
  void read_face(FT_Face face, const std::string& prefix) {
    if (FT_HAS_MULTIPLE_MASTERS(face)) ++read_.left_out["variations of a font, except its default instance"];
    std::vector<std::string> tables;
    const auto load = [&](const char* tag) { return tables.emplace_back(table(face, tag)).size() > 0; };
    const bool is_cff = load("CFF ") || load("CFF2");
    if (!is_cff) {
      for (const char* tag : {"head", "maxp", "hhea", "hmtx", "glyf", "loca"}) load(tag);
      if (tables.back().empty()) throw Malformed("it has no outlines: none of the tables glyf, CFF and CFF2");
    }
    const auto [outlines, is_new] = seen_.insert(std::move(tables));
    if (!is_new) {
      ++read_.left_out["faces with the outlines of a face before"];
    } else if (is_cff) {
      draw(Cff(outlines->back(), outlines->size() == 2), face, prefix);
    } else {
      const auto& t = *outlines;
      draw(Glyf({.head = t[2], .maxp = t[3], .hhea = t[4], .hmtx = t[5], .glyf = t[6], .loca = t[7]}), face, prefix);
    }
  }

  /// The bytes of a table; none where the font does not have it.
  std::string table(FT_Face face, const char* tag) {
    const FT_ULong number = BigEndian({tag, 4}).u32();
    FT_ULong size = 0;
    if (FT_Load_Sfnt_Table(face, number, 0, nullptr, &size) != 0) return {};
    loaded_ += size;
    if (loaded_ > most_bytes) throw Malformed(fmt::format("its tables have more than {} bytes", most_bytes));
    std::string bytes(size, '\0');
    if (FT_Load_Sfnt_Table(face, number, 0, reinterpret_cast<FT_Byte*>(bytes.data()), &size) != 0)
      throw Malformed(fmt::format("its table {} is cut off", tag));
    return bytes;
  }

  template <class Glyphs>
  void draw(const Glyphs& glyphs, FT_Face face, const std::string& prefix) {
    GlyphNames names(face);
    for (std::size_t glyph = 0; glyph < glyphs.glyph_count(); ++glyph) {
      const auto name = names(glyph);
      outline_.begin_glyph(prefix + name);
      try {
        glyphs.draw(glyph, outline_);
      } catch (const Malformed& wrong) {
        throw Malformed(fmt::format("glyph {}{}: {}", prefix, name, wrong.what()));
      }
    }
  }

  Read read_;
  Outline outline_{read_};
  std::size_t loaded_ = 0;
  std::set<std::vector<std::string>> seen_;  ///< the tables of outlines of the faces
};

}  // namespace

Read read_font(std::string_view contents, const std::string& name) {
  try {
    return Reader().read(contents);
  } catch (const Malformed& wrong) {
    throw Unreadable(
        fmt::format("{}: {}; give a font whose tables are whole, as TrueType, OpenType or WOFF", name, wrong.what()));
  }
}

}  // namespace bezierbench::curves
