// SPDX-License-Identifier: MIT
// Sets of curves as CSV (RFC 4180): the columns `curve` (or `segment`) and `index`, then optionally `form`, the axes
// x, y, z, and optionally `w`, the weights of rational curves, and `t`, parameters. One coefficient per row, ascending;
// points are not premultiplied by their weights. A file without the column `curve` is one curve.
#pragma once

#include <string>
#include <string_view>

#include "reference/curves/read.hpp"

namespace bezierbench::curves {

/// Reads a set. Columns may stand in any order. In a file with the column `curve` the field `w` is empty for polynomial
/// curves, fields of the last axes are empty for curves of a lower dimension, and rows below the last coefficient of a
/// curve may have a `t` alone. A curve continues the path of the one above it where CurveSet::continues_path() says so.
/// Throws Unreadable that names file, line and column for anything but finite numbers under a valid header, weights
/// that are all zero, and rows out of order; std::invalid_argument where `form` is power and a file without the column
/// `form` has weights, which belong to control points.
Read read_csv(std::string_view text, const std::string& name, Form form);

/// The set as CSV with hexadecimal numbers; read_csv() with the Bernstein form gives an equal set of the same bits.
std::string to_csv(const CurveSet& set);

}  // namespace bezierbench::curves
