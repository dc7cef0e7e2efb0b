// SPDX-License-Identifier: MIT
// `curve derivative`: the derivative of one order of one curve by any method, against the exact one.
#include <fmt/format.h>

#include <memory>

#include "core/derivative/kernel.hpp"
#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/curve_table.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "experiments/number/number.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::cli {
namespace {

struct DerivativeOptions {
  CurveOptions curve;
  std::vector<std::string> t;
  int order = 0;
  std::vector<std::string> methods;
};

/// The true derivative at one t, and the scales of errors there.
struct DerivativeTarget {
  double t;
  reference::ExactPoint truth;
  reference::ExactPoint p_tilde;
  std::vector<metric::DerivativeScale> scales;  ///< one per axis
};

DerivativeTarget target_of(const CurveFile& curve, int order, double t) {
  reference::ExactCurve exact;
  DerivativeTarget target{
      t, exact.derivative(curve.view(), order, t), exact.derivative_p_tilde(curve.view(), order, t), {}};
  target.scales.resize(static_cast<std::size_t>(curve.dimension));
  for (int axis = 0; axis < curve.dimension; ++axis) {
    std::vector<double> coefficients;
    for (int i = 0; i <= curve.degree(); ++i) coefficients.push_back(curve.view()(axis, i));
    target.scales[static_cast<std::size_t>(axis)].set({curve.form, 1, curve.degree(), coefficients}, order, t);
  }
  return target;
}

void add_rows(const DerivativeKernel& method, const CurveFile& curve, int order, const DerivativeTarget& target,
              CurveTable& table) {
  std::vector<double> point(static_cast<std::size_t>(curve.dimension));
  method.derivative(curve.view(), order, target.t, point.data());
  for (int axis = 0; axis < curve.dimension; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const auto p_tilde = target.p_tilde.coordinate(axis);
    std::vector<std::string> row{std::string(method.info->id), number::decimal(target.t), std::to_string(order),
                                 axis_name(axis)};
    for (auto& field : judged_coordinate(point[k], target.truth.coordinate(axis), p_tilde))
      row.push_back(std::move(field));
    row.push_back(method.bound == nullptr
                      ? ""
                      : bound_field(target.scales[k].bound(*method.bound, reference::double_arithmetic), p_tilde));
    table.add_row(std::move(row));
  }
}

void differentiate(const DerivativeOptions& options, const CurveFile& curve, CurveTable& table) {
  const auto methods = chosen(derivative_kernels(curve.dimension), options.methods, curve, ids_of(derivative_infos()));
  if (methods.empty()) refuse_curve(options.curve.file, curve, *derivative_infos().front());
  std::vector<DerivativeTarget> targets;
  for (const auto& text : options.t) targets.push_back(target_of(curve, options.order, finite_option("--t", text)));
  for (const auto* method : methods)
    for (const auto& target : targets) add_rows(*method, curve, options.order, target, table);
}

}  // namespace

void add_curve_derivative(Command curve) {
  auto options = std::make_shared<DerivativeOptions>();
  auto command = curve.command("derivative", "evaluate a derivative of a curve");
  options->curve.add_to(command);
  command.option("--t", options->t, "parameter; may be repeated").required().takes("T");
  command.option("--order", options->order, "order of the derivative; 0 is the point itself").required().within(0);
  command.option("--method", options->methods, "method id; may be repeated; default: all that apply")
      .takes("METHOD", methods_of(Problem::derivative));
  command.action([options] {
    print_rows_of_curves(*options,
                         {"method", "t", "order", "axis", "value", "exact", "error", "error_ulp", "error_u", "bound_u"},
                         differentiate);
  });
}

}  // namespace bezierbench::cli
