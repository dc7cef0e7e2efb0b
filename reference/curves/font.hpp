// SPDX-License-Identifier: MIT
// Reads the glyphs of a font file.
#pragma once

#include <string>
#include <string_view>

#include "reference/curves/read.hpp"

namespace bezierbench::curves {

/// The outlines of every glyph of a font (.ttf, .otf, .ttc, .woff, .woff2), in the order of the font, in font units;
/// each contour is a path. Coordinates are those of the file, composed exactly; of a variable font those of its default
/// instance. Ids are `glyph:contour:segment`, from 0, where a glyph is called by its name, or else by its number. Where
/// the file has several faces, the face's number and a colon precede them; faces that differ only in tables other than
/// outlines are left out. `name` is the file's, for messages. Throws Unreadable.
Read read_font(std::string_view contents, const std::string& name);

}  // namespace bezierbench::curves
