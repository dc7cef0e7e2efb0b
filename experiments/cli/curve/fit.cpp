// SPDX-License-Identifier: MIT
// `curve fit`: cubic Bezier segments near points.
#include <algorithm>
#include <string_view>

#include "core/fit/kernel.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "reference/number/number.hpp"

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

/// The vector in the text of an option, if it is given. Throws Failure(usage) for the zero vector.
std::vector<double> direction_option(const std::string& option, const std::optional<std::string>& text, int dimension) {
  if (!text) return {};
  auto direction = finite_coordinates(option, *text, dimension, "the points have");
  if (std::ranges::all_of(direction, [](double x) { return x == 0; }))
    throw Failure(Exit::usage, "{} {}: the zero vector has no direction; leave the option out, or give one that has",
                  option, *text);
  return direction;
}

void fit(const FitOptions& options) {
  const double tolerance = finite_option("--tolerance", options.tolerance);
  if (tolerance < 0)
    throw Failure(Exit::usage, "--tolerance {}: must be 0 or more; it is a distance, in the units of the coordinates",
                  options.tolerance);
  auto points = read_points(options.points);
  const int d = points.dimension;
  auto& x = points.coordinates;
  if (options.closed && !points.ends_where_it_starts())
    for (int axis = 0; axis < d; ++axis) x.push_back(x[static_cast<std::size_t>(axis)]);
  const auto start = direction_option("--start-direction", options.start_direction, d);
  const auto end = direction_option("--end-direction", options.end_direction, d);
  const auto& method = chosen_one(fitting_kernels(d), options.method, Problem::fitting);
  const auto fit = method.fit(x, tolerance, {start, end});
  if (!fit.converged)
    throw Failure(Exit::input_output, "{}: a control point exceeds the largest double; scale the points down",
                  options.points);
  fmt::print("{}", segments_csv(fit.control_points, d));
  const int segments = fit.segments(d);
  fmt::print(stderr, "bezierbench: {} segment{}, maximum error {}\n", segments, segments == 1 ? "" : "s",
             number::decimal(fit.max_error));
}

void add_fit(Command command) {
  auto options = std::make_shared<FitOptions>();
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

}  // namespace

extern constexpr CurveCommand curve_fit{"fit", "fit a piecewise cubic curve to points", add_fit};

}  // namespace bezierbench::cli
