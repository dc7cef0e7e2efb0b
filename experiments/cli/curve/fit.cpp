// SPDX-License-Identifier: MIT
// `curve fit`: cubic Bezier segments that are nowhere farther from points than a tolerance.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "core/fit/kernel.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/point_file.hpp"
#include "experiments/cli/curve/segment_rows.hpp"
#include "experiments/cli/startup/known_values.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {
namespace {

/// The default method: on most data it needs fewer segments than Schneider's, and it recovers a cubic from points on
/// it.
constexpr std::string_view default_method = "gauss_newton";

struct FitOptions {
  std::string points;
  std::string tolerance;
  std::string method = std::string(default_method);
};

/// The method `id` for this dimension. Throws Failure(usage) for an unknown id.
const FittingKernel& chosen_kernel(const std::string& id, int dimension) {
  const auto kernels = fitting_kernels(dimension);
  const auto found = std::ranges::find_if(kernels, [&](const auto& kernel) { return kernel.info->id == id; });
  if (found == kernels.end()) unknown_method(id, ids_of(fitting_infos()));
  return *found;
}

void fit(const FitOptions& options) {
  const double tolerance = finite_option("--tolerance", options.tolerance);
  if (tolerance < 0)
    throw Failure(Exit::usage, fmt::format("--tolerance {}: must be 0 or more; it is a distance, in the units of the "
                                           "coordinates",
                                           options.tolerance));
  const auto points = read_points(options.points, 2);
  const auto fit = chosen_kernel(options.method, points.dimension).fit(points.coordinates, tolerance, {});
  if (!fit.converged)
    throw Failure(Exit::input_output, fmt::format("{}: a control point exceeds the largest double; scale the points "
                                                  "down",
                                                  options.points));
  print_segments(fit.control_points, points.dimension);
  const int segments = fit.segments(points.dimension);
  fmt::print(stderr, "bezierbench: {} segment{}, maximum error {}\n", segments, segments == 1 ? "" : "s",
             number::decimal(fit.max_error));
}

}  // namespace

void add_curve_fit(Command curve) {
  auto options = std::make_shared<FitOptions>();
  auto command = curve.command("fit", "a piecewise cubic near points");
  command.option("--points", options->points, "point file (CSV)").required().takes(file_value);
  command.option("--tolerance", options->tolerance, "largest distance of a point from the curve, in its units")
      .required();
  command.option("--method", options->method, fmt::format("method id; default {}", default_method))
      .takes("METHOD", methods_of(Problem::fitting));
  command.action([options] { fit(*options); });
}

}  // namespace bezierbench::cli
