// SPDX-License-Identifier: MIT
// Curve files: CSV with a header that names the axes, one coefficient per row, ascending.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/curve.hpp"

namespace bezierbench::cli {

struct CurveFile {
  Form form = Form::bernstein;
  int dimension = 0;
  std::vector<double> coefficients;  ///< point by point

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) / dimension - 1; }
  [[nodiscard]] CurveView<double> view() const { return {form, dimension, degree(), coefficients}; }
};

/// The name of an axis: x, y, z.
std::string axis_name(int axis);

/// Throws Failure(input_output) that names file, row and column for anything but finite numbers under a good header.
CurveFile read_curve(const std::filesystem::path& file, Form form);

/// The same layout, decimal.
std::string curve_csv(const CurveFile& curve);

}  // namespace bezierbench::cli
