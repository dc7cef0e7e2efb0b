// SPDX-License-Identifier: MIT
// `curve part` and `curve elevate`: the true control points of a part of each curve, or of the curve in a higher degree,
// rounded once, as a set of curves.
#include <algorithm>
#include <cmath>

#include "experiments/cli/curve/curve_command.hpp"
#include "reference/companion/exact_split.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

using Computed = std::optional<reference::RoundedControlPoints>;

/// Prints what `compute` makes of every curve; `id` is that of a curve without one.
template <class Compute>
void print_set(const CurveOptions& options, const std::string& id, const Compute& compute) {
  const auto curves = options.read();
  curves::CurveSet set;
  for (const auto& curve : curves) {
    const auto name = curves.size() > 1 ? fmt::format("{}#{}", options.name(), echo(curve.id)) : options.name();
    if (curve.form == Form::power)
      throw Failure(Exit::usage, "{}: is in power form, without control points; see `curve convert`", name);
    const Computed computed = compute(curve.view(), name);
    if (!computed)
      throw Failure(Exit::usage, "{}: a control point would have the weight zero; choose other parameters", name);
    const auto is_finite = [](double x) { return std::isfinite(x); };
    if (!std::ranges::all_of(computed->points, is_finite) || !std::ranges::all_of(computed->weights, is_finite))
      throw Failure(Exit::input_output, "{}: a control point exceeds the largest double; scale the coordinates down",
                    name);
    const int degree = static_cast<int>(computed->points.size()) / curve.dimension - 1;
    set.add(curve.id.empty() ? id : curve.id,
            {curve.form, curve.dimension, degree, computed->points, computed->weights});
  }
  fmt::print("{}", curves::to_csv(set, number::decimal));
}

void add_part(Command command) {
  struct Options {
    CurveOptions curve;
    std::string from;
    std::string to;
  };
  const auto options = std::make_shared<Options>();
  options->curve.add_to(command);
  command.option("--from", options->from, "parameter where the part starts").required().takes("T");
  command.option("--to", options->to, "parameter where it ends; may be below --from, and both may be outside of [0, 1]")
      .required()
      .takes("T");
  command.action([options] {
    const double from = finite_option("--from", options->from);
    const double to = finite_option("--to", options->to);
    print_set(options->curve, "part", [&](const CurveView<double>& curve, const std::string& /*name*/) {
      return reference::control_points_of_part(curve, from, to);
    });
  });
}

void add_elevate(Command command) {
  struct Options {
    CurveOptions curve;
    int degree = 0;
  };
  const auto options = std::make_shared<Options>();
  options->curve.add_to(command);
  command.option("--degree", options->degree, "degree of the result, at least that of the curve")
      .required()
      .within(0, max_degree);
  command.action([options] {
    print_set(options->curve, "elevated", [&](const CurveView<double>& curve, const std::string& name) {
      if (options->degree < curve.degree)
        throw Failure(Exit::usage, "--degree {}: {} has degree {}; write that or a higher one", options->degree, name,
                      curve.degree);
      return reference::elevated_control_points(curve, options->degree);
    });
  });
}

}  // namespace

extern constexpr CurveCommand curve_part{"part", "compute the control points of a part of a curve", add_part};
extern constexpr CurveCommand curve_elevate{"elevate", "compute the control points of a curve in a higher degree",
                                            add_elevate};

}  // namespace bezierbench::cli
