// SPDX-License-Identifier: MIT
// `curve project`: the projection of a point onto one curve by any method, against the exact foot point.
#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/judge/methods.hpp"
#include "reference/companion/projection.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct Project {
  static constexpr Problem problem = Problem::projection;
  static std::vector<std::string> columns() {
    return {"method", "t", "distance", "candidates", "exact_t", "exact_distance", "error"};
  }
  static auto kernels(int dimension) { return judge::projection_methods(dimension); }

  void add_to(Command command) {
    command.option("--point", point, "coordinates, separated by commas").required().takes("X,Y[,Z]");
  }
  void add_rows(const CurveCase<ProjectionKernel>& one, CurveTable& table) const;

  std::string point;
  TruthOption truth;
};

void Project::add_rows(const CurveCase<ProjectionKernel>& one, CurveTable& table) const {
  const auto curve = one.curve.view();
  const auto from = finite_coordinates("--point", point, curve.dimension, fmt::format("the curve in {} has", one.name));
  std::optional<reference::ExactProjection> exact;
  std::string t;
  std::string distance;
  if (truth.finishes(one.name, curve.degree, [&] { exact = reference::projection(curve, from); })) {
    t = number::decimal(reference::round_to(reference::binary64, exact->foot().t));
    distance = number::decimal(reference::square_root(reference::binary64, exact->foot().distance_squared));
  }
  for (const auto* method : one.methods) {
    const auto foot = method->project(curve, from);
    const auto error =
        exact ? number::decimal(reference::foot_error(reference::binary64, foot.t, foot.distance, *exact)) : "";
    table.add_row({std::string(method->info->id), number::decimal(foot.t), number::decimal(foot.distance),
                   std::to_string(foot.candidates), t, distance, error});
    if (!foot.converged)
      fmt::print(stderr, "bezierbench: {} gave up before it converged; its row is the best it found\n",
                 method->info->id);
  }
}

}  // namespace

extern constexpr CurveCommand curve_project{"project", "find the point of a curve nearest to a given point",
                                            add_curve_command<Project>};

}  // namespace bezierbench::cli
