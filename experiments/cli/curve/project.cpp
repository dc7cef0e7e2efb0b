// SPDX-License-Identifier: MIT
// `curve project`: the projection of a point onto one curve by any method, against the exact foot point.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/curve_table.hpp"
#include "experiments/cli/curve/truth_option.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/number/number.hpp"
#include "reference/companion/projection.hpp"

namespace bezierbench::cli {
namespace {

struct ProjectOptions {
  CurveOptions curve;
  std::string point;
  std::vector<std::string> methods;
  TruthOption truth;
};

/// Parses `X,Y[,Z]`. Throws Failure(usage) unless there are as many coordinates as the curve has axes.
std::vector<double> point_option(const std::string& text, const CurveFile& curve, const std::string& file) {
  auto point = finite_numbers("--point", text);
  if (point.size() != static_cast<std::size_t>(curve.dimension))
    throw Failure(Exit::usage, fmt::format("--point {}: {} coordinates, but the curve in {} has {}; write one per axis",
                                           text, point.size(), file, curve.dimension));
  return point;
}

void project(const ProjectOptions& options, const CurveFile& curve, CurveTable& table) {
  const auto point = point_option(options.point, curve, options.curve.file);
  const auto kernels = judge::projection_methods(curve.dimension);
  const auto methods = chosen(kernels, options.methods, curve, ids_in(kernels));
  if (methods.empty()) refuse_curve(options.curve.file, curve, *kernels.front().info);
  std::optional<reference::ExactProjection> exact;
  std::string t;
  std::string distance;
  if (options.truth.finishes(options.curve.file, curve.degree(),
                             [&] { exact = reference::projection(curve.view(), point); })) {
    t = number::decimal(reference::round_to(reference::binary64, exact->foot().t));
    distance = number::decimal(reference::square_root(reference::binary64, exact->foot().distance_squared));
  }
  for (const auto* kernel : methods) {
    const auto foot = kernel->project(curve.view(), point);
    const auto error =
        exact ? number::decimal(reference::foot_error(reference::binary64, foot.t, foot.distance, *exact)) : "";
    table.add_row({std::string(kernel->info->id), number::decimal(foot.t), number::decimal(foot.distance),
                   std::to_string(foot.candidates), t, distance, error});
    if (!foot.converged)
      fmt::print(stderr, "bezierbench: {} gave up before it converged; its row is the best it found\n",
                 kernel->info->id);
  }
}

}  // namespace

void add_curve_project(Command curve) {
  auto options = std::make_shared<ProjectOptions>();
  auto command = curve.command("project", "find the point of a curve nearest to a given point");
  options->curve.add_to(command);
  command.option("--point", options->point, "coordinates, separated by commas").required().takes("X,Y[,Z]");
  command.option("--method", options->methods, "method id; may be repeated; default: all that apply")
      .takes("METHOD", methods_of(Problem::projection));
  options->truth.add_to(command);
  command.action([options] {
    print_rows_of_curves(*options, {"method", "t", "distance", "candidates", "exact_t", "exact_distance", "error"},
                         project);
  });
}

}  // namespace bezierbench::cli
