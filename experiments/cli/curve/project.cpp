// SPDX-License-Identifier: MIT
// `curve project`: the projection of points onto curves by any method, against the exact foot points.
#include <array>
#include <limits>

#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/judge/methods.hpp"
#include "reference/companion/projection.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct Project {
  static constexpr Problem problem = Problem::projection;
  static std::vector<std::string> columns(int dimension) {
    return with_axes({"method", "t", "distance", "candidates", "exact_t", "exact_distance", "error"}, dimension);
  }
  static std::vector<std::string> path_columns(int dimension) {
    return with_axes(
        {"method", "segment", "t", "distance", "candidates", "exact_segment", "exact_t", "exact_distance", "error"},
        dimension);
  }
  static auto kernels(int dimension) { return judge::projection_methods(dimension); }

  void add_to(Command command) {
    command.option("--point", points, "coordinates, separated by commas; may be repeated")
        .one_each_time()
        .takes("X,Y[,Z]");
    command.option("--points", file, "file of more points (CSV)").takes(file_value);
  }
  void prepare(bool whole_path);
  [[nodiscard]] std::size_t questions() const { return points.size() + from_file.count(); }
  void add_rows(const CurveCase<ProjectionKernel>& one, CurveTable& table) const;
  void add_path_rows(std::span<const CurveCase<ProjectionKernel>> segments, CurveTable& table) const;

  std::vector<std::string> points;
  std::optional<std::string> file;
  PointList from_file;
  TruthOption truth;

 private:
  /// The exact feet on all segments, and the segment of the nearest; none where one of them takes too long.
  struct PathTruth {
    std::vector<std::optional<reference::ExactProjection>> exact;
    std::optional<std::size_t> nearest;
  };

  [[nodiscard]] std::vector<double> point(std::size_t question, const CurveCase<ProjectionKernel>& one) const;
  [[nodiscard]] PathTruth truth_of(std::size_t question, std::span<const CurveCase<ProjectionKernel>> segments) const;
};

void Project::prepare(bool /*whole_path*/) {
  if (points.empty() && !file) throw Failure(Exit::usage, "--point is required; write --point X,Y, or --points FILE");
  if (file) from_file = read_points(*file, 1);
}

/// The coordinates of a question. Throws Failure(usage) unless it has as many as the curve.
std::vector<double> Project::point(std::size_t question, const CurveCase<ProjectionKernel>& one) const {
  if (question < points.size())
    return finite_coordinates("--point", points[question], one.curve.dimension,
                              fmt::format("the curve in {} has", one.name));
  if (from_file.dimension != one.curve.dimension)
    throw Failure(Exit::usage, "--points {}: {} coordinates, but the curve in {} has {}; write one per axis", *file,
                  from_file.dimension, one.name, one.curve.dimension);
  const auto d = static_cast<std::size_t>(from_file.dimension);
  const auto coordinates = std::span(from_file.coordinates).subspan((question - points.size()) * d, d);
  return {coordinates.begin(), coordinates.end()};
}

/// The exact foot point of one question, if it is known.
using ExactFoot = std::optional<reference::ExactProjection>;

/// The nearest doubles to the t and the distance of the exact foot point.
std::array<std::string, 2> foot_fields(const ExactFoot& exact) {
  if (!exact) return {};
  return {number::decimal(reference::round_to(reference::binary64, exact->foot().t)),
          number::decimal(reference::square_root(reference::binary64, exact->foot().distance_squared))};
}

void say_unless_converged(const ProjectionKernel& method, const FootPoint& foot) {
  if (!foot.converged)
    fmt::print(stderr, "bezierbench: {} gave up before it converged; its row is the best it found\n", method.info->id);
}

void Project::add_rows(const CurveCase<ProjectionKernel>& one, CurveTable& table) const {
  const auto curve = one.curve.view();
  refuse_pole(curve, 0, 1, one.name);
  std::vector<std::vector<double>> from;
  std::vector<ExactFoot> exact(questions());
  for (std::size_t k = 0; k < questions(); ++k) {
    from.push_back(point(k, one));
    (void)truth.finishes(one.name, curve.degree, [&] { exact[k] = reference::projection(curve, from[k]); });
  }
  for (const auto* method : one.methods)
    for (std::size_t k = 0; k < questions(); ++k) {
      const auto foot = method->project(curve, from[k]);
      const auto [t, distance] = foot_fields(exact[k]);
      const auto error =
          exact[k] ? number::decimal(reference::foot_error(reference::binary64, foot.t, foot.distance, *exact[k])) : "";
      table.add_row({std::string(method->info->id), number::decimal(foot.t), number::decimal(foot.distance),
                     std::to_string(foot.candidates), t, distance, error},
                    k, point_fields_at(curve, foot.t, one.dimension));
      say_unless_converged(*method, foot);
    }
}

Project::PathTruth Project::truth_of(std::size_t question,
                                     std::span<const CurveCase<ProjectionKernel>> segments) const {
  PathTruth path{std::vector<ExactFoot>(segments.size()), {}};
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto curve = segments[s].curve.view();
    refuse_pole(curve, 0, 1, segments[s].name);
    const auto from = point(question, segments[s]);
    auto& exact = path.exact[s];
    if (!truth.finishes(segments[s].name, curve.degree, [&] { exact = reference::projection(curve, from); }))
      return {std::move(path.exact), {}};
    if (!path.nearest ||
        reference::less(exact->foot().distance_squared, path.exact[*path.nearest]->foot().distance_squared))
      path.nearest = s;
  }
  return path;
}

/// The nearest of the feet on all segments; of equally near ones the first. Methods come first, then points.
void Project::add_path_rows(std::span<const CurveCase<ProjectionKernel>> segments, CurveTable& table) const {
  std::vector<PathTruth> truths;
  for (std::size_t k = 0; k < questions(); ++k) truths.push_back(truth_of(k, segments));
  for (std::size_t m = 0; m < segments.front().methods.size(); ++m)
    for (std::size_t k = 0; k < questions(); ++k) {
      FootPoint best{.distance = std::numeric_limits<double>::infinity()};
      std::size_t at = 0;
      std::int64_t candidates = 0;
      for (std::size_t s = 0; s < segments.size(); ++s) {
        const auto foot = segments[s].methods[m]->project(segments[s].curve.view(), point(k, segments[s]));
        say_unless_converged(*segments[s].methods[m], foot);
        candidates += foot.candidates;
        if (!(foot.distance < best.distance)) continue;
        best = foot;
        at = s;
      }
      const auto& [exact, nearest] = truths[k];
      std::array<std::string, 2> exact_foot;
      std::string error;
      if (nearest) {
        exact_foot = foot_fields(exact[*nearest]);
        // The least distance is that of the path; the error of t is seen on the segment that the method chose.
        auto of_path = *exact[at];
        of_path.critical[of_path.nearest].distance_squared = exact[*nearest]->foot().distance_squared;
        error = number::decimal(reference::foot_error(reference::binary64, best.t, best.distance, of_path));
      }
      table.add_row({std::string(segments[at].methods[m]->info->id), std::to_string(at), number::decimal(best.t),
                     number::decimal(best.distance), std::to_string(candidates),
                     nearest ? std::to_string(*nearest) : "", exact_foot[0], exact_foot[1], error},
                    k, point_fields_at(segments[at].curve.view(), best.t, segments[at].dimension));
    }
}

}  // namespace

extern constexpr CurveCommand curve_project{"project", "find the points of a curve nearest to given points",
                                            add_curve_command<Project>};

}  // namespace bezierbench::cli
