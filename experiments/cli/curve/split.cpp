// SPDX-License-Identifier: MIT
// `curve split`: the control points of both halves of one curve by any method, against the exact ones.
#include <deque>

#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/studies/subdivision/split_truth.hpp"

namespace bezierbench::cli {
namespace {

using studies::Side;

struct Split {
  static constexpr Problem problem = Problem::subdivision;
  static std::vector<std::string> columns() {
    auto columns = judged_columns({"method", "half", "index"});
    std::erase(columns, "error_ulp");
    return columns;
  }
  static auto kernels(int dimension) { return split_kernels(dimension); }

  void add_to(Command command) {
    command.option("--t", t, "parameter at which the curve is split").required().takes("T");
  }
  void add_rows(const CurveCase<SplitKernel>& one, CurveTable& table) const;

  std::string t;
};

/// The truth of one axis alone, so that bounds are those of a single coordinate.
struct Axis {
  Axis(CurveFile alone, double t) : curve(std::move(alone)), truth(curve.view(), t) {}

  CurveFile curve;
  studies::SplitTruth truth;
};

void Split::add_rows(const CurveCase<SplitKernel>& one, CurveTable& table) const {
  const auto curve = one.curve.view();
  const double at = finite_option("--t", t);
  const auto exact = reference::exact_split(curve, at);
  const auto p_tilde = reference::split_p_tilde(curve, at);
  std::deque<Axis> axes;
  for (int axis = 0; axis < curve.dimension; ++axis) axes.emplace_back(one.curve.along(axis), at);
  for (const auto* half : {&exact.left, &exact.right})
    for (const auto& point : half->points)
      if (!point.exists())
        throw Failure(Exit::usage, fmt::format("--t {}: a control point of a half would have the weight zero, so {} "
                                               "cannot be split there; see column w or choose another t",
                                               t, one.name));

  const auto add_half = [&](const SplitKernel& method, const studies::ComputedHalves& computed, Side side) {
    const bool left = side == Side::left;
    const auto& true_half = left ? exact.left : exact.right;
    const auto& p_tilde_half = left ? p_tilde.left : p_tilde.right;
    for (int i = 0; i <= curve.degree; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const auto control = computed.control(side, i);
      const auto add = [&](const std::string& axis, std::vector<std::string> judged) {
        std::vector<std::string> row{std::string(method.info->id), left ? "left" : "right", std::to_string(i), axis};
        judged.erase(judged.begin() + 3);  // the field error_ulp
        row.insert(row.end(), judged.begin(), judged.end());
        table.add_row(std::move(row));
      };
      for (int axis = 0; axis < curve.dimension; ++axis) {
        const auto value = control.subspan(static_cast<std::size_t>(axis), 1);
        const auto& truth = axes[static_cast<std::size_t>(axis)].truth;
        add(axis_name(axis),
            judged_coordinate(value[0], true_half.points[k].coordinate(axis), p_tilde_half.points[k].coordinate(axis),
                              truth.point_error(method.bound, side, i, value).bound));
      }
      if (curve.form == Form::rational)
        add("w", judged_coordinate(control.back(), true_half.weights[k], p_tilde_half.weights[k],
                                   axes[0].truth.weight_error(method.bound, side, i, control.back()).bound));
    }
  };
  for (const auto* method : one.methods) {
    std::vector<double> numbers;
    studies::compute_halves(*method, curve, at, numbers);
    const studies::ComputedHalves computed(curve, std::move(numbers));
    for (const Side side : studies::sides) add_half(*method, computed, side);
  }
}

}  // namespace

extern constexpr CurveCommand curve_split{"split", "split a curve into two halves", add_curve_command<Split>};

}  // namespace bezierbench::cli
