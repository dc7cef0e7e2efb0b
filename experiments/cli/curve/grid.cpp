// SPDX-License-Identifier: MIT
// `curve grid`: the points of one curve on a uniform grid by any method, against the exact ones.
#include "core/grid/grid.hpp"

#include <fmt/format.h>

#include <memory>

#include "core/grid/kernel.hpp"
#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/curve_table.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/metric/bound_at.hpp"
#include "experiments/number/number.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::cli {
namespace {

struct GridOptions {
  CurveOptions curve;
  int points = 0;
  std::vector<std::string> methods;
};

/// One axis of the curve, as a curve of dimension 1, so that bounds are those of a single coordinate.
std::vector<double> axis_of(const CurveFile& curve, int axis) {
  std::vector<double> coefficients;
  for (int i = 0; i <= curve.degree(); ++i) coefficients.push_back(curve.view()(axis, i));
  return coefficients;
}

void add_grid_rows(const GridKernel& method, const CurveFile& curve, int steps, CurveTable& table) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  std::vector<double> points(static_cast<std::size_t>(steps + 1) * d);
  method.points(curve.view(), steps, points.data());
  reference::ExactCurve exact;
  reference::TrialScale scale;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const auto truth = exact.point(curve.view(), t);
    const auto p_tilde = exact.p_tilde(curve.view(), t);
    const auto at = metric::bound_at(*method.bound, curve.degree(), k, steps, reference::double_arithmetic);
    for (int axis = 0; axis < curve.dimension; ++axis) {
      const auto coefficients = axis_of(curve, axis);
      scale.set({curve.form, 1, curve.degree(), coefficients}, t);
      std::vector<std::string> row{std::string(method.info->id), std::to_string(k), number::decimal(t),
                                   axis_name(axis)};
      const double value = points[static_cast<std::size_t>(k) * d + static_cast<std::size_t>(axis)];
      for (auto& field : judged_coordinate(value, truth.coordinate(axis), p_tilde.coordinate(axis)))
        row.push_back(std::move(field));
      row.push_back(bound_field(scale.bound(at, reference::double_arithmetic), p_tilde.coordinate(axis)));
      table.add_row(std::move(row));
    }
  }
}

void run_grid(const GridOptions& options, const CurveFile& curve, CurveTable& table) {
  if (!is_grid(options.points - 1))
    throw Failure(Exit::usage, fmt::format("--points {}: must be a power of two and one, 2 to {}", options.points,
                                           max_grid_steps + 1));
  const auto methods = chosen(grid_kernels(curve.dimension), options.methods, curve, ids_of(grid_infos()));
  if (methods.empty()) refuse_curve(options.curve.file, curve, *grid_infos().front());
  for (const auto* method : methods) add_grid_rows(*method, curve, options.points - 1, table);
}

}  // namespace

void add_curve_grid(Command curve) {
  auto options = std::make_shared<GridOptions>();
  auto command = curve.command("grid", "evaluate a curve at k/m, k = 0..m");
  options->curve.add_to(command);
  command.option("--points", options->points, "number of points, m + 1, where m is a power of two")
      .required()
      .within(2);
  command.option("--method", options->methods, "method id; may be repeated; default: all that apply")
      .takes("METHOD", methods_of(Problem::grid));
  command.action([options] {
    print_rows_of_curves(*options,
                         {"method", "index", "t", "axis", "value", "exact", "error", "error_ulp", "error_u", "bound_u"},
                         run_grid);
  });
}

}  // namespace bezierbench::cli
