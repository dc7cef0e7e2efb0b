// SPDX-License-Identifier: MIT
// The files of `curve` commands. Curve files: CSV with a header that names the axes and, for a rational curve, the weights
// (w), in any order; one coefficient per row, ascending. Points are not premultiplied by their weights. Several curves are
// distinguished by the columns `curve` (also called `segment`) and `index`; a column `form` states the form of each. Point
// files: the axes only, one point per row.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::cli {

/// The name of an axis: x, y or z.
std::string axis_name(int axis);

struct CurveFile {
  std::string id;  ///< within its file; empty in a file without a column for it
  Form form = Form::bernstein;
  int dimension = 0;
  std::vector<double> coefficients;  ///< point by point
  std::vector<double> weights;       ///< of a rational curve; otherwise empty

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) / dimension - 1; }
  [[nodiscard]] CurveView<double> view() const { return {form, dimension, degree(), coefficients, weights}; }
  /// One axis as a curve of dimension 1, whose bounds are those of a single coordinate.
  [[nodiscard]] CurveFile along(int axis) const;
};

/// Parses a curve file, one curve or more. Where no column `form` states it, polynomial coefficients are in `form`.
/// Weights make a curve rational; only the Bernstein form may have them, else throws Failure(usage). A curve of a file
/// with a column for ids may leave the weights empty and is polynomial then. Throws Failure(input_output) that names
/// file, row and column for anything but finite numbers under a valid header, weights that are all zero, and rows out of
/// order.
std::vector<CurveFile> parse_curves(std::string_view text, const std::string& file_name, Form form);

/// Reads and parses what an option --curve names: a file, or FILE#ID, one curve of a file by its id or else by its
/// number from 0. A file of the whole name comes first. Throws as parse_curves() does, Failure(input_output) for a file
/// that cannot be read, and Failure(usage) for a curve that is not in it.
std::vector<CurveFile> read_curves(const std::string& name, Form form);

/// Curves of one dimension, without weights, in the layout of curve files, in decimal; with the columns `curve` and
/// `index` if there are several.
std::string curves_csv(std::span<const CurveFile> curves);

struct PointFile {
  int dimension = 0;
  std::vector<double> coordinates;  ///< point by point
  std::vector<std::size_t> lines;   ///< of the file, one for each point

  [[nodiscard]] std::size_t count() const { return coordinates.size() / static_cast<std::size_t>(dimension); }
  [[nodiscard]] bool ends_where_it_starts() const;
};

/// Reads two points or more. Throws Failure(input_output) that names file, row and column for anything but finite numbers
/// under a valid header, for fewer points, and for a file that cannot be read.
PointFile read_points(const std::string& file);

/// Cubic Bezier segments as rows segment,index,x[,y[,z]] below a header, one control point per row. `segments` has four
/// control points per segment, point by point. Segments and their points are numbered from 0.
std::string segments_csv(std::span<const double> segments, int dimension);

}  // namespace bezierbench::cli
