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
  std::vector<double> weights;       ///< of a rational curve, else none

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) / dimension - 1; }
  [[nodiscard]] CurveView<double> view() const { return {form, dimension, degree(), coefficients, weights}; }
};

/// The curve in a file's text whose polynomial coefficients are in `form`; a rational one where there is a column w,
/// which only the Bernstein form may have (else Failure(usage)). Throws Failure(input_output) that names file, row and
/// column for anything but finite numbers under a good header, and for weights that are all zero.
CurveFile parse_curve(std::string_view text, const std::string& file_name, Form form);

/// As parse_curve, from a file; Failure(input_output) as well for one that cannot be read.
CurveFile read_curve(const std::filesystem::path& file, Form form);

/// The same layout, decimal, for a curve without weights.
std::string curve_csv(const CurveFile& curve);

}  // namespace bezierbench::cli
