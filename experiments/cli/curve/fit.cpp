// SPDX-License-Identifier: MIT
// `curve fit`: cubic Bezier segments near points.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fit/kernel.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/point_file.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {
namespace {

/// The default method: on most data it makes fewer segments than Schneider's, and it recovers a cubic from points on
/// it.
constexpr std::string_view default_method = "gauss_newton";

struct FitOptions {
  std::string points;
  std::string tolerance;
  std::string method = std::string(default_method);
  std::optional<std::string> start_direction;
  std::optional<std::string> end_direction;
  bool closed = false;
};

/// The method `id` for this dimension. Throws Failure(usage) for an unknown id.
const FittingKernel& chosen_kernel(const std::string& id, int dimension) {
  const auto kernels = fitting_kernels(dimension);
  const auto found = std::ranges::find_if(kernels, [&](const auto& kernel) { return kernel.info->id == id; });
  if (found == kernels.end()) unknown_method(id, ids_of(fitting_infos()));
  return *found;
}

/// Parses the `X,Y[,Z]` of a direction, if there is one. Throws Failure(usage) unless there are as many coordinates as the
/// points have axes, one of them not 0.
std::vector<double> direction_option(const std::string& option, const std::optional<std::string>& given,
                                     int dimension) {
  if (!given) return {};
  const auto& text = *given;
  auto direction = finite_numbers(option, text);
  if (direction.size() != static_cast<std::size_t>(dimension))
    throw Failure(Exit::usage, fmt::format("{} {}: {} coordinate{}, but the points have {}; write one per axis", option,
                                           text, direction.size(), direction.size() == 1 ? "" : "s", dimension));
  if (std::ranges::all_of(direction, [](double x) { return x == 0; }))
    throw Failure(Exit::usage,
                  fmt::format("{} {}: the zero vector has no direction; leave the option out, or give one that has",
                              option, text));
  return direction;
}

/// Appends the first of the points if it is not the last one.
void close(PointFile& points) {
  auto& x = points.coordinates;
  if (!std::equal(x.begin(), x.begin() + points.dimension, x.end() - points.dimension))
    for (int axis = 0; axis < points.dimension; ++axis) x.push_back(x[static_cast<std::size_t>(axis)]);
}

void fit(const FitOptions& options) {
  const double tolerance = finite_option("--tolerance", options.tolerance);
  if (tolerance < 0)
    throw Failure(Exit::usage, fmt::format("--tolerance {}: must be 0 or more; it is a distance, in the units of the "
                                           "coordinates",
                                           options.tolerance));
  auto points = read_points(options.points, 2);
  if (options.closed) close(points);
  const auto start = direction_option("--start-direction", options.start_direction, points.dimension);
  const auto end = direction_option("--end-direction", options.end_direction, points.dimension);
  const auto fit = chosen_kernel(options.method, points.dimension).fit(points.coordinates, tolerance, {start, end});
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
  auto command = curve.command("fit", "fit a piecewise cubic curve to points");
  command.option("--points", options->points, "point file (CSV)").required().takes(file_value);
  command.option("--tolerance", options->tolerance, "largest distance of a point from the curve, in coordinate units")
      .required();
  command.option("--method", options->method, fmt::format("method id; default {}", default_method))
      .takes("METHOD", methods_of(Problem::fitting));
  command.option("--start-direction", options->start_direction, "tangent direction at the start").takes("X,Y[,Z]");
  command.option("--end-direction", options->end_direction, "tangent direction at the end").takes("X,Y[,Z]");
  command.flag("--closed", options->closed, "fit a closed curve, from the last point back to the first");
  command.action([options] { fit(*options); });
}

}  // namespace bezierbench::cli
