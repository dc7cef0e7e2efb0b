// SPDX-License-Identifier: MIT
// `curve derivative`: the derivative of one order of one curve by any method, against the exact one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/derivative/kernel.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct Derivative {
  static constexpr Problem problem = Problem::derivative;
  static constexpr const char* control_points_help =
      "print the coefficients of the derivative, each rounded once, as a set of curves in the form of the curve";
  static std::vector<std::string> columns() { return judged_columns({"method", "t", "order"}); }
  static auto kernels(int dimension) { return derivative_kernels(dimension); }

  void add_to(Command command) {
    command.option("--t", t, "parameter; may be repeated; required without --control-points").takes("T");
    command.option("--order", order, "order of the derivative; 0 is the point itself").required().within(0);
  }
  void prepare(bool whole_path) const;
  void add_rows(const CurveCase<DerivativeKernel>& one, CurveTable& table) const;
  void add_to_set(std::span<const CurveCase<DerivativeKernel>> cases, const std::string& id,
                  curves::CurveSet& set) const;

  std::vector<std::string> t;
  int order = 0;
  bool control_points = false;
};

/// The true derivative at one t, and the scales of errors there.
struct DerivativeTarget {
  DerivativeTarget(const CurveFile& curve, int order, double parameter)
      : t(parameter),
        truth(reference::ExactCurve().derivative(curve.view(), order, t)),
        p_tilde(reference::ExactCurve().derivative_p_tilde(curve.view(), order, t)),
        scales(static_cast<std::size_t>(curve.dimension)) {
    for (int axis = 0; axis < curve.dimension; ++axis)
      scales[static_cast<std::size_t>(axis)].set(curve.along(axis).view(), order, t);
  }

  double t;
  reference::ExactPoint truth;
  reference::ExactPoint p_tilde;
  std::vector<metric::DerivativeScale> scales;  ///< one per axis
};

void Derivative::prepare(bool /*whole_path*/) const {
  if (control_points == t.empty()) return;
  throw Failure(Exit::usage, control_points ? "--control-points: takes no --t; leave one of them out"
                                            : "--t is required; write --t T, or --control-points");
}

void Derivative::add_to_set(std::span<const CurveCase<DerivativeKernel>> cases, const std::string& id,
                            curves::CurveSet& set) const {
  const auto& curve = cases.front().curve;
  if (curve.form == Form::rational)
    throw Failure(Exit::usage, fmt::format("{}: the derivative of a rational curve is not one of its degree; leave out "
                                           "--control-points and ask for values by --t",
                                           cases.front().name));
  const auto coefficients = reference::ExactCurve().derivative_coefficients(curve.view(), order);
  if (std::ranges::any_of(coefficients, [](double value) { return !std::isfinite(value); }))
    throw Failure(Exit::input_output,
                  "{}: a coefficient of the derivative is beyond the largest double; scale the coordinates down",
                  cases.front().name);
  set.add(id.empty() ? fmt::format("order_{}", order) : id,
          {curve.form, curve.dimension, std::max(curve.degree() - order, 0), coefficients});
}

void Derivative::add_rows(const CurveCase<DerivativeKernel>& one, CurveTable& table) const {
  std::vector<DerivativeTarget> targets;
  for (const double at : finite_options("--t", t)) {
    targets.emplace_back(one.curve, order, at);
    require_point(targets.back().truth, at, one.name);
  }
  std::vector<double> point(static_cast<std::size_t>(one.curve.dimension));
  for (const auto* method : one.methods)
    for (const auto& target : targets) {
      method->derivative(one.curve.view(), order, target.t, point.data());
      table.add_point({std::string(method->info->id), number::decimal(target.t), std::to_string(order)}, point,
                      target.truth, target.p_tilde, [&](int axis) -> std::optional<double> {
                        if (method->bound == nullptr) return std::nullopt;
                        const auto& scale = target.scales[static_cast<std::size_t>(axis)];
                        return scale.bound(*method->bound, reference::double_arithmetic);
                      });
    }
}

}  // namespace

extern constexpr CurveCommand curve_derivative{"derivative", "evaluate a derivative of a curve",
                                               add_curve_command<Derivative>};

}  // namespace bezierbench::cli
