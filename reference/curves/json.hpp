// SPDX-License-Identifier: MIT
// Curves as JSON, as Python and JavaScript print them.
#pragma once

#include <string>
#include <string_view>

#include "reference/curves/read.hpp"

namespace bezierbench::curves {

/// Reads one curve, an array of points `[[x,y], ...]`, or several, an array of such arrays, at any depth. A curve can
/// also be an object: `points`, and optionally `weights`, `form` and `id`. Ids are else the numbers of the curves from
/// 0; a curve continues the path of the one before where CurveSet::continues_path() says so. Polynomial curves without
/// `form` are in `form`. Throws Unreadable.
Read read_json(std::string_view text, const std::string& name, Form form);

}  // namespace bezierbench::curves
