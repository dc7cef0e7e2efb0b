// SPDX-License-Identifier: MIT
// Sets of curves as CSV (RFC 4180): the columns `curve` (or `segment`) and `index`, then optionally `form`, the axes
// x, y, z, and optionally `w`, the weights of rational curves, and `t`, parameters. One coefficient per row, ascending;
// points are not premultiplied by their weights. A file without the column `curve` is one curve.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "reference/curves/read.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::curves {

/// The axes, as columns and messages name them.
inline constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};

/// Reads a set. Columns may stand in any order. In a file with the column `curve` the field `w` is empty for polynomial
/// curves, fields of the last axes are empty for curves of a lower dimension, and rows below the last coefficient of a
/// curve may have a `t` alone. A curve continues the path of the one above it where CurveSet::continues_path() says so.
/// Throws Unreadable that names file, line and column for anything but finite numbers under a valid header, weights
/// that are all zero, and rows out of order; std::invalid_argument where `form` is power and a file without the column
/// `form` has weights, which belong to control points.
Read read_csv(std::string_view text, const std::string& name, Form form);

/// The set as CSV, each number written by `number`; read_csv() with the Bernstein form gives an equal set of the same
/// bits.
std::string to_csv(const CurveSet& set, std::string (*number)(double) = number::hexadecimal);

/// Points without order or form, one a row below a header that names the axes.
struct PointList {
  int dimension = 1;
  std::vector<double> coordinates;  ///< point by point
  std::vector<double> weights;      ///< one for each point of a file with the column `w`, else none
  std::vector<std::size_t> lines;   ///< of the file, one for each point

  [[nodiscard]] std::size_t count() const { return coordinates.size() / static_cast<std::size_t>(dimension); }
  [[nodiscard]] bool ends_where_it_starts() const;
};

/// Reads points, with a column `w` where `weights` allows it. Throws Unreadable for anything but finite numbers under a
/// valid header.
PointList read_points_csv(std::string_view text, const std::string& name, bool weights = false);

}  // namespace bezierbench::curves
