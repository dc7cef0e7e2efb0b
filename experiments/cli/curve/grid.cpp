// SPDX-License-Identifier: MIT
// `curve grid`: the points of one curve on a uniform grid by any method, against the exact ones.
#include "core/grid/grid.hpp"

#include "core/grid/kernel.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct Grid {
  static constexpr Problem problem = Problem::grid;
  static std::vector<std::string> columns() { return judged_columns({"method", "index", "t"}); }
  static auto kernels(int dimension) { return grid_kernels(dimension); }

  void add_to(Command command) {
    command.option("--points", points, "number of points, m + 1, where m is a power of two").required().within(2);
  }
  void add_rows(const CurveCase<GridKernel>& one, CurveTable& table) const;

  int points = 0;
};

void Grid::add_rows(const CurveCase<GridKernel>& one, CurveTable& table) const {
  const int steps = points - 1;
  if (!is_grid(steps))
    throw Failure(Exit::usage, "--points {}: must be a power of two and one, 2 to {}", points, max_grid_steps + 1);
  const auto curve = one.curve.view();
  const auto d = static_cast<std::size_t>(curve.dimension);
  refuse_pole(curve, 0, 1, one.name);
  std::vector<CurveFile> coordinates;
  for (int axis = 0; axis < curve.dimension; ++axis) coordinates.push_back(one.curve.along(axis));
  std::vector<double> computed(static_cast<std::size_t>(points) * d);
  reference::ExactCurve exact;
  reference::TrialScale scale;
  for (const auto* method : one.methods) {
    method->points(curve, steps, computed.data());
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const auto at = metric::bound_at(*method->bound, curve.degree, k, steps, reference::double_arithmetic);
      const reference::ExactPoint truth = exact.point(curve, t);  // a copy: p_tilde() overwrites it
      table.add_point({std::string(method->info->id), std::to_string(k), number::decimal(t)},
                      std::span(computed).subspan(static_cast<std::size_t>(k) * d, d), truth, exact.p_tilde(curve, t),
                      [&](int axis) {
                        scale.set(coordinates[static_cast<std::size_t>(axis)].view(), t);
                        return scale.bound(at, reference::double_arithmetic);
                      });
    }
  }
}

}  // namespace

extern constexpr CurveCommand curve_grid{"grid", "evaluate a curve at k/m, k = 0..m", add_curve_command<Grid>};

}  // namespace bezierbench::cli
