// SPDX-License-Identifier: MIT
// Curve files: CSV with a header that names the axes and, for a rational curve, the weights (w), in any order; one
// coefficient per row, ascending. Points are not premultiplied by their weights. Several curves are told apart by the
// columns `curve` (also called `segment`) and `index`; a column `form` says the form of each.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::cli {

struct CurveFile {
  std::string id;  ///< within its file; empty in a file without a column for it
  Form form = Form::bernstein;
  int dimension = 0;
  std::vector<double> coefficients;  ///< point by point
  std::vector<double> weights;       ///< of a rational curve; otherwise empty

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) / dimension - 1; }
  [[nodiscard]] CurveView<double> view() const { return {form, dimension, degree(), coefficients, weights}; }
};

/// Parses a curve file, one curve or more. Where no column `form` says it, polynomial coefficients are in `form`.
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

}  // namespace bezierbench::cli
