// SPDX-License-Identifier: MIT
// Reads files of curves, each by its kind: CSV, SVG, fonts, JSON.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/curves/curve_set.hpp"

namespace bezierbench::curves {

/// A file that cannot be read as curves: what() is one line that names the file, the line and column where there is
/// one, and what to do.
class Unreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Limits of every reader; a file beyond them is Unreadable.
inline constexpr std::size_t most_bytes = std::size_t{256} << 20U;
inline constexpr std::size_t most_curves = 10'000'000;
inline constexpr int most_nesting = 256;

struct Read {
  CurveSet set;
  std::map<std::string, std::size_t> left_out;  ///< how many things of a kind were not read, by the reason
};

struct ReadOptions {
  /// That of polynomial coefficients in files that do not state it: CSV without a column `form`, and JSON.
  Form form = Form::bernstein;
  /// Reads models, STEP and IGES; without it they are Unreadable.
  Read (*model)(std::string_view contents, const std::string& name) = nullptr;
};

/// Whether `name` ends with an extension that decides the kind of a file for read().
bool has_known_extension(const std::string& name);

/// Reads the contents of a file. `name` decides the kind by its extension (.csv, .svg, .ttf, .otf, .ttc, .woff, .woff2,
/// .json, .txt for bare path data, .step, .stp, .iges, .igs) and is named in messages; without a known extension the
/// contents decide. Throws Unreadable.
Read read(std::string_view contents, const std::string& name, const ReadOptions& options = {});

struct NamedRead {
  std::string name;  ///< of the file
  Read read;
};

/// The curves of all files, in their order. Ids stay as they are in one file, and where they are different in all; else
/// all are `STEM:ID`, STEM being the file's name without folders and extension, with a number where that occurs twice,
/// and `STEM` for a curve without an id. Throws Unreadable for more curves than a set may have.
Read joined(std::span<const NamedRead> files);

/// Reads the curves that an SVG document draws, by [SVG 2]: paths and basic shapes with their transforms, `use`
/// expanded. Only what is rendered: not what is in `defs`, `clipPath`, `mask`, `pattern`, `marker` or a `symbol` that
/// is not used, and nothing with `display:none` in an attribute. Ids are `PATH:SUBPATH:SEGMENT`, counted from 0; PATH
/// is the id of the element where it has one that is not in use before. Coordinates are those of the outermost `svg`,
/// in px; `viewBox`, style sheets and CSS transforms are not applied. Entities are not expanded. Throws Unreadable for
/// what is not XML, and for an attribute that has an error, since what follows the error is unknown.
Read read_svg(std::string_view text, const std::string& name);

/// Reads JSON, as Python and JavaScript print it: one curve, an array of points `[[x,y], ...]`, or several, an array of
/// such arrays, at any depth. A curve can also be an object: `points`, and optionally `weights`, `form` and `id`. Ids
/// are else the numbers of the curves from 0; a curve continues the path of the one before where
/// CurveSet::continues_path() says so. Polynomial curves without `form` are in `form`. Throws Unreadable.
Read read_json(std::string_view text, const std::string& name, Form form);

/// The outlines of every glyph of a font (.ttf, .otf, .ttc, .woff, .woff2), in the order of the font, in font units;
/// each contour is a path. Coordinates are those of the file, composed exactly; of a variable font those of its default
/// instance. Ids are `glyph:contour:segment`, from 0, where a glyph is called by its name, or else by its number. Where
/// the file has several faces, the face's number and a colon precede them; faces that differ only in tables other than
/// outlines are left out. `name` is the file's, for messages. Throws Unreadable.
Read read_font(std::string_view contents, const std::string& name);

// What the readers share: how they refuse a place of their text, and how curves enter a set within the limits.

/// A text and the name of its file, for messages.
struct Source {
  std::string_view text;
  std::string name;

  /// Throws Unreadable with `NAME:LINE:COLUMN: what` for the byte `offset`. Lines and columns are counted from 1,
  /// columns in bytes.
  [[noreturn]] void refuse(std::size_t offset, std::string_view what) const;
};

/// Throws Unreadable that names the file where `set` has as many curves as a set may.
void require_room(const CurveSet& set, std::string_view name);

}  // namespace bezierbench::curves
