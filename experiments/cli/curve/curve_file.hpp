// SPDX-License-Identifier: MIT
// The files of `curve` commands: sets of curves in any format of reference/curves, and lists of points in CSV.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/curves/csv.hpp"
#include "reference/curves/read.hpp"

namespace bezierbench::cli {

using curves::PointList;

/// The name of an axis: x, y or z.
std::string axis_name(int axis);

struct CurveFile {
  std::string id;  ///< within its file; empty in a file without ids
  Form form = Form::bernstein;
  int dimension = 0;
  std::vector<double> coefficients;  ///< point by point
  std::vector<double> weights;       ///< of a rational curve; otherwise empty
  bool begins_path = true;           ///< false where it is joined to the one before it

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) / dimension - 1; }
  [[nodiscard]] CurveView<double> view() const { return {form, dimension, degree(), coefficients, weights}; }
  /// One axis as a curve of dimension 1, whose bounds are those of a single coordinate.
  [[nodiscard]] CurveFile along(int axis) const;
};

/// The bytes of a file, or of standard input where it is `-`, of which no more are read than a reader takes. Throws
/// Failure(input_output) for a file that cannot be read.
std::string contents_of(const std::string& file);

/// Reads all curves of a file; `-` is standard input. Polynomial coefficients are in `form` where the file states none.
/// Throws Failure(input_output) for a file that cannot be read, and Failure(usage) where `form` is power and the
/// weights of a file belong to control points.
curves::Read read_set(const std::string& file, Form form);

/// Reads what an option --curve names: a file, or FILE#ID: one curve by its id or else by its number from 0, or else
/// the curves of the path or part of a path whose ids begin with `ID:`. A file of the whole name comes first. Throws as
/// read_set() does, and Failure(usage) for a curve that is not in it.
std::vector<CurveFile> read_curves(const std::string& name, Form form);

/// The curves of SVG path data, which messages call --path. Throws Failure(input_output).
std::vector<CurveFile> path_curves(const std::string& data);

/// Curves of one dimension, without weights, in the layout of curve files, in decimal; with the columns `curve` and
/// `index` if there are several.
std::string curves_csv(std::span<const CurveFile> curves);

/// Reads at least so many points, with a column `w` where `weights` allows it. Throws Failure(input_output) for fewer
/// points, and for a file that cannot be read.
PointList read_points(const std::string& file, std::size_t least = 2, bool weights = false);

/// Cubic Bezier segments as rows segment,index,x[,y[,z]] below a header, one control point per row. `segments` has four
/// control points per segment, point by point. Segments and their points are numbered from 0.
std::string segments_csv(std::span<const double> segments, int dimension);

}  // namespace bezierbench::cli
