// SPDX-License-Identifier: MIT
// `curve derivative`: the derivative of one order of one curve by any method, against the exact one.
#include "core/derivative/kernel.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct Derivative {
  static constexpr Problem problem = Problem::derivative;
  static std::vector<std::string> columns() { return judged_columns({"method", "t", "order"}); }
  static auto kernels(int dimension) { return derivative_kernels(dimension); }

  void add_to(Command command) {
    command.option("--t", t, "parameter; may be repeated").required().takes("T");
    command.option("--order", order, "order of the derivative; 0 is the point itself").required().within(0);
  }
  void add_rows(const CurveCase<DerivativeKernel>& one, CurveTable& table) const;

  std::vector<std::string> t;
  int order = 0;
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

void Derivative::add_rows(const CurveCase<DerivativeKernel>& one, CurveTable& table) const {
  std::vector<DerivativeTarget> targets;
  for (const double at : finite_options("--t", t)) targets.emplace_back(one.curve, order, at);
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
