// SPDX-License-Identifier: MIT
// Curve files: CSV with a header that names the axes and, for a rational curve, the weights (w), in any order; one
// coefficient per row, ascending. Points are not premultiplied by their weights.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::cli {

struct CurveFile {
  Form form = Form::bernstein;
  int dimension = 0;
  std::vector<double> coefficients;  ///< point by point
  std::vector<double> weights;       ///< of a rational curve; otherwise empty

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) / dimension - 1; }
  [[nodiscard]] CurveView<double> view() const { return {form, dimension, degree(), coefficients, weights}; }
};

/// Parses a curve file, whose polynomial coefficients are in `form`. A column w makes it a rational curve; only the
/// Bernstein form may have one, else throws Failure(usage). Throws Failure(input_output) that names file, row and
/// column for anything but finite numbers under a valid header, and for weights that are all zero.
CurveFile parse_curve(std::string_view text, const std::string& file_name, Form form);

/// Reads and parses a curve file. Throws as parse_curve() does, and Failure(input_output) for a file that cannot be
/// read.
CurveFile read_curve(const std::filesystem::path& file, Form form);

/// A curve without weights in the layout of curve files, in decimal.
std::string curve_csv(const CurveFile& curve);

}  // namespace bezierbench::cli
