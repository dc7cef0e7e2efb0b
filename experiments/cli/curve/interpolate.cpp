// SPDX-License-Identifier: MIT
// `curve interpolate`: the cubic Bezier segments of a spline through points.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/interpolate/kernel.hpp"
#include "core/interpolate/spline.hpp"
#include "experiments/cli/curve/curve_command.hpp"

namespace bezierbench::cli {
namespace {

struct InterpolateOptions {
  std::string points;
  std::optional<std::string> parameters;
  std::string ends{spline_ends_names.front()};
  std::optional<std::string> start_derivative;
  std::optional<std::string> end_derivative;
  bool closed = false;
  bool monotone = false;
  std::string method;
};

template <class Word, std::size_t n>
Word word_of(const std::array<std::string_view, n>& names, std::string_view name) {
  return static_cast<Word>(std::ranges::find(names, name) - names.begin());
}

template <std::size_t n>
std::vector<std::string> words(const std::array<std::string_view, n>& names) {
  return {names.begin(), names.end()};
}

/// The parameters; without the option those that the method has, if one is named.
Parameters parameters_of(const InterpolateOptions& options) {
  if (options.parameters) return word_of<Parameters>(parameters_names, *options.parameters);
  return options.method.empty() ? Parameters{} : Parameters::uniform;
}

/// One number per axis. Throws Failure(usage) for another count, and where the option and clamped ends are not
/// together.
std::vector<double> derivative_of(const std::string& option, const std::optional<std::string>& text, bool clamped,
                                  int dimension) {
  if (clamped != text.has_value())
    throw Failure(Exit::usage, clamped ? fmt::format("--ends clamped: {} must say the derivative there", option)
                                       : fmt::format("{}: is that of clamped ends; see --ends", option));
  if (!clamped) return {};
  return finite_coordinates(option, *text, dimension, "the points have");
}

/// The steps of the parameter. Throws Failure(input_output) that names the row where one is 0.
std::vector<double> steps_of(const InterpolateOptions& options, const PointList& points) {
  auto steps = knot_steps(points.coordinates, points.dimension, parameters_of(options), options.closed);
  const auto repeated = static_cast<std::size_t>(std::ranges::find(steps, 0.0) - steps.begin());
  if (repeated < steps.size())
    throw Failure(Exit::input_output,
                  "{}:{}: repeats the point before it, so that the parameter takes no step; leave the row out, or see "
                  "--parameters uniform",
                  options.points, points.lines[(repeated + 1) % points.count()]);
  return steps;
}

void interpolate(const InterpolateOptions& options) {
  auto points = read_points(options.points);
  if (options.closed && points.count() > 2 && points.ends_where_it_starts())
    points.coordinates.resize(points.coordinates.size() - static_cast<std::size_t>(points.dimension));
  const auto ends = word_of<SplineEnds>(spline_ends_names, options.ends);
  const bool clamped = ends == SplineEnds::clamped;
  if (options.closed && ends != SplineEnds::natural)
    throw Failure(Exit::usage, "--ends {}: a closed spline has no ends; leave --closed out", options.ends);
  const auto start = derivative_of("--start-derivative", options.start_derivative, clamped, points.dimension);
  const auto end = derivative_of("--end-derivative", options.end_derivative, clamped, points.dimension);
  const bool by_method = !options.method.empty();
  const auto& kernel = by_method ? chosen_one(interpolation_kernels(), options.method, Problem::interpolation)
                                 : interpolation_kernels().front();
  if (by_method && (parameters_of(options) != Parameters::uniform || ends != SplineEnds::natural || options.closed ||
                    options.monotone))
    throw Failure(Exit::usage,
                  "--method {}: has uniform parameters and natural ends, is open and not monotone; leave --method or "
                  "the other options out",
                  options.method);
  const auto segments = by_method ? kernel.interpolate(points.coordinates, points.dimension)
                                  : spline_segments(points.coordinates, points.dimension, steps_of(options, points),
                                                    {ends, options.closed, options.monotone, start, end});
  const auto beyond = std::ranges::find_if(segments, [](double value) { return !std::isfinite(value); });
  if (beyond != segments.end())
    throw Failure(Exit::input_output,
                  "{}: a control point of segment {} exceeds the largest double; scale the points down", options.points,
                  (beyond - segments.begin()) / (4 * points.dimension));
  fmt::print("{}", segments_csv(segments, points.dimension));
}

void add_interpolate(Command command) {
  auto options = std::make_shared<InterpolateOptions>();
  command.option("--points", options->points, "point file (CSV)").required().takes(file_value);
  command
      .option(
          "--parameters", options->parameters,
          fmt::format("steps of the parameter: the square root of the distance of points, or equal, or the distance; "
                      "default {}, which does not run back between points that are unevenly spaced on a line",
                      parameters_names.front()))
      .one_of(words(parameters_names));
  command
      .option("--ends", options->ends,
              "end conditions: second derivative 0, given derivatives, or one cubic over two segments")
      .one_of(words(spline_ends_names));
  command
      .option("--start-derivative", options->start_derivative,
              "derivative at a clamped start: 3 (P1 - P0) of the first segment")
      .takes("X,Y[,Z]");
  command
      .option("--end-derivative", options->end_derivative,
              "derivative at a clamped end: 3 (P3 - P2) of the last segment")
      .takes("X,Y[,Z]");
  command.flag("--closed", options->closed,
               "close the spline from the last point to the first; it is C2 there as well");
  command.flag("--monotone", options->monotone,
               "make each coordinate monotone between neighbouring points; second derivatives then jump");
  command
      .option("--method", options->method,
              fmt::format("method id, for uniform parameters and natural ends; default there {}",
                          interpolation_kernels().front().info->id))
      .takes("METHOD", methods_of(Problem::interpolation));
  command.action([options] { interpolate(*options); });
}

}  // namespace

extern constexpr CurveCommand curve_interpolate{"interpolate", "interpolate points by a C2 cubic spline",
                                                add_interpolate};

}  // namespace bezierbench::cli
