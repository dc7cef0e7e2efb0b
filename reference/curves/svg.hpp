// SPDX-License-Identifier: MIT
// The curves that an SVG document draws, by [SVG 2]: paths and basic shapes with their transforms, `use` expanded.
#pragma once

#include <string>
#include <string_view>

#include "reference/curves/read.hpp"

namespace bezierbench::curves {

/// Reads what is rendered: not what is in `defs`, `clipPath`, `mask`, `pattern`, `marker` or a `symbol` that is not
/// used, and nothing with `display:none` in an attribute. Ids are `PATH:SUBPATH:SEGMENT`, counted from 0; PATH is the
/// id of the element where it has one that is not in use before. Coordinates are those of the outermost `svg`, in px;
/// `viewBox`, style sheets and CSS transforms are not applied. Entities are not expanded. Throws Unreadable for what is
/// not XML, and for an attribute that has an error, since what follows the error is unknown.
Read read_svg(std::string_view text, const std::string& name);

}  // namespace bezierbench::curves
