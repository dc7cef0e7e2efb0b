// SPDX-License-Identifier: MIT
// `curve interpolate`: the cubic Bezier segments of a C2 natural spline through points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/interpolate/kernel.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/point_file.hpp"
#include "experiments/cli/curve/segment_rows.hpp"

namespace bezierbench::cli {
namespace {

struct InterpolateOptions {
  std::string points;
  std::string method;
};

/// The method `id`, or the first one if `id` is empty. Throws Failure(usage) for an unknown id.
const InterpolationKernel& chosen_kernel(const std::string& id) {
  const auto kernels = interpolation_kernels();
  if (id.empty()) return kernels.front();
  const auto found = std::ranges::find_if(kernels, [&](const auto& kernel) { return kernel.info->id == id; });
  if (found == kernels.end()) unknown_method(id, ids_of(interpolation_infos()));
  return *found;
}

void interpolate(const InterpolateOptions& options) {
  const auto& kernel = chosen_kernel(options.method);
  const auto points = read_points(options.points, 2);
  const auto segments = kernel.interpolate(points.coordinates, points.dimension);
  const auto beyond = std::ranges::find_if(segments, [](double value) { return !std::isfinite(value); });
  if (beyond != segments.end())
    throw Failure(Exit::input_output,
                  fmt::format("{}: a control point of segment {} exceeds the largest double; scale the points down",
                              options.points, (beyond - segments.begin()) / (4 * points.dimension)));
  print_segments(segments, points.dimension);
}

}  // namespace

void add_curve_interpolate(Command curve) {
  auto options = std::make_shared<InterpolateOptions>();
  auto command = curve.command("interpolate", "the C2 natural cubic spline through points");
  command.option("--points", options->points, "point file (CSV)").required().takes(file_value);
  command.option("--method", options->method,
                 fmt::format("method id; default {}", interpolation_kernels().front().info->id));
  command.action([options] { interpolate(*options); });
}

}  // namespace bezierbench::cli
