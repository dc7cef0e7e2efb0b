// SPDX-License-Identifier: MIT
// `curve split`: the control points of both halves of one curve by any method, against the exact ones.
#include <fmt/format.h>

#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/curve_table.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/number/number.hpp"
#include "experiments/studies/subdivision/split_truth.hpp"

namespace bezierbench::cli {
namespace {

using studies::Side;

struct SplitOptions {
  CurveOptions curve;
  std::string t;
  std::vector<std::string> methods;
};

/// One axis of the curve, as a curve of dimension 1, so that bounds are those of a single coordinate.
struct Axis {
  Axis(const CurveFile& curve, int axis, double t)
      : coefficients([&] {
          std::vector<double> all;
          for (int i = 0; i <= curve.degree(); ++i) all.push_back(curve.view()(axis, i));
          return all;
        }()),
        truth({curve.form, 1, curve.degree(), coefficients, curve.weights}, t) {}

  std::vector<double> coefficients;
  studies::SplitTruth truth;
};

/// The true halves, and the scales of errors.
struct SplitTarget {
  SplitTarget(const CurveFile& curve, double parameter)
      : t(parameter),
        exact(reference::exact_split(curve.view(), parameter)),
        p_tilde(reference::split_p_tilde(curve.view(), parameter)) {
    for (int axis = 0; axis < curve.dimension; ++axis) axes.emplace_back(curve, axis, parameter);
  }

  double t;
  reference::ExactHalves exact;
  reference::ExactHalves p_tilde;
  std::deque<Axis> axes;
};

void require_points(const reference::ExactHalf& half, const SplitOptions& options) {
  for (const auto& point : half.points)
    if (!point.exists())
      throw Failure(Exit::usage, fmt::format("--t {}: a control point of a half would have the weight zero, so {} "
                                             "cannot be split there; see column w or choose another t",
                                             options.t, options.curve.file));
}

/// The fields of the columns value,exact,error,error_u,bound_u.
std::vector<std::string> judged(double value, const reference::Rational& truth, const reference::Rational& p_tilde,
                                double bound) {
  auto fields = judged_coordinate(value, truth, p_tilde);
  fields.erase(fields.begin() + 3);  // the field error_ulp
  fields.push_back(bound_field(bound, p_tilde));
  return fields;
}

void add_split_rows(const SplitKernel& method, const CurveFile& curve, const SplitTarget& target, CurveTable& table) {
  std::vector<double> numbers;
  studies::compute_halves(method, curve.view(), target.t, numbers);
  const studies::ComputedHalves computed(curve.view(), std::move(numbers));
  for (const Side side : studies::sides) {
    const bool left = side == Side::left;
    const auto& exact = left ? target.exact.left : target.exact.right;
    const auto& p_tilde = left ? target.p_tilde.left : target.p_tilde.right;
    for (int i = 0; i <= curve.degree(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const auto control = computed.control(side, i);
      const auto add = [&](const std::string& axis, std::vector<std::string> fields) {
        std::vector<std::string> row{std::string(method.info->id), left ? "left" : "right", std::to_string(i), axis};
        row.insert(row.end(), fields.begin(), fields.end());
        table.add_row(std::move(row));
      };
      for (int axis = 0; axis < curve.dimension; ++axis) {
        const auto value = control.subspan(static_cast<std::size_t>(axis), 1);
        const auto& truth = target.axes[static_cast<std::size_t>(axis)].truth;
        add(axis_name(axis), judged(value[0], exact.points[k].coordinate(axis), p_tilde.points[k].coordinate(axis),
                                    truth.point_error(method.bound, side, i, value).bound));
      }
      if (curve.form == Form::rational)
        add("w", judged(control.back(), exact.weights[k], p_tilde.weights[k],
                        target.axes[0].truth.weight_error(method.bound, side, i, control.back()).bound));
    }
  }
}

void split(const SplitOptions& options, const CurveFile& curve, CurveTable& table) {
  const auto methods = chosen(split_kernels(curve.dimension), options.methods, curve, ids_of(split_infos()));
  if (methods.empty()) refuse_curve(options.curve.file, curve, *split_infos().front());
  const SplitTarget target(curve, finite_option("--t", options.t));
  require_points(target.exact.left, options);
  require_points(target.exact.right, options);
  for (const auto* method : methods) add_split_rows(*method, curve, target, table);
}

}  // namespace

void add_curve_split(Command curve) {
  auto options = std::make_shared<SplitOptions>();
  auto command = curve.command("split", "split a curve into two halves");
  options->curve.add_to(command);
  command.option("--t", options->t, "parameter at which the curve is split").required().takes("T");
  command.option("--method", options->methods, "method id; may be repeated; default: all that apply")
      .takes("METHOD", methods_of(Problem::subdivision));
  command.action([options] {
    print_rows_of_curves(*options, {"method", "half", "index", "axis", "value", "exact", "error", "error_u", "bound_u"},
                         split);
  });
}

}  // namespace bezierbench::cli
