// SPDX-License-Identifier: MIT
// `curve box`: the box of one curve by any method, against the tightest box of doubles.
#include <algorithm>
#include <cmath>

#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/studies/bounds/problem.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct Box {
  static constexpr Problem problem = Problem::bounds;
  static std::vector<std::string> columns() {
    return {"method", "axis", "low", "high", "tightest_low", "tightest_high", "low_ulp", "high_ulp", "contains"};
  }
  static auto kernels(int dimension) { return bounds_kernels(dimension); }

  void add_to(Command /*command*/) {}
  void add_rows(const CurveCase<BoundsKernel>& one, CurveTable& table) const;
};

void Box::add_rows(const CurveCase<BoundsKernel>& one, CurveTable& table) const {
  const auto curve = one.curve.view();
  const bool one_sign = std::ranges::all_of(curve.weights, [](double w) { return w > 0; });
  std::vector<reference::ExactRange> truth;
  for (int axis = 0; one_sign && axis < curve.dimension; ++axis) truth.push_back(reference::exact_range(curve, axis));
  std::vector<double> sides(2 * static_cast<std::size_t>(curve.dimension));
  for (const auto* method : one.methods) {
    method->box(curve, sides.data());
    for (int axis = 0; axis < curve.dimension; ++axis) {
      const double low = sides[2 * static_cast<std::size_t>(axis)];
      const double high = sides[2 * static_cast<std::size_t>(axis) + 1];
      std::vector<std::string> row{std::string(method->info->id), axis_name(axis), number::decimal(low),
                                   number::decimal(high)};
      if (truth.empty() || std::isnan(low) || std::isnan(high)) {
        row.insert(row.end(), 5, "");
      } else {
        const auto& range = truth[static_cast<std::size_t>(axis)];
        const double below = studies::side_error(low, range.low).ulp;
        const double above = studies::side_error(-high, -range.high).ulp;
        for (const double x : {range.low, range.high, below, above}) row.push_back(number::decimal(x));
        row.emplace_back(below >= 0 && above >= 0 ? "yes" : "no");
      }
      table.add_row(std::move(row));
    }
  }
}

}  // namespace

extern constexpr CurveCommand curve_box{"box", "compute a box that contains a curve", add_curve_command<Box>};

}  // namespace bezierbench::cli
