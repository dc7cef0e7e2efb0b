// SPDX-License-Identifier: MIT
// `curve eval`: points of one curve by any method, against the exact ones.
#include <algorithm>

#include "core/evaluate/kernel/prepared_state.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/judge/methods.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct Eval {
  static constexpr Problem problem = Problem::evaluation;
  static std::vector<std::string> columns() { return judged_columns({"method", "t"}); }
  static auto kernels(int dimension) { return judge::methods<double>(dimension); }

  void add_to(Command command) { command.option("--t", t, "parameter; may be repeated").required().takes("T"); }
  void add_rows(CurveCase<Kernel<double>> one, CurveTable& table) const;

  std::vector<std::string> t;
};

/// Leaves out the methods that have no point at some t. Throws Failure(usage) for a method that is named and has none.
void require_points(const std::vector<double>& ts, CurveCase<Kernel<double>>& one) {
  const auto outside = std::ranges::find_if(ts, [](double t) { return t < 0 || t > 1; });
  if (outside == ts.end()) return;
  const auto ends_there = [](const auto* kernel) { return kernel->info->unit_interval_only; };
  const auto ended = std::ranges::find_if(one.methods, ends_there);
  if (one.named && ended != one.methods.end())
    throw Failure(Exit::usage, "--method {}: takes t in [0,1] only, --t is {}; see `list methods`", (*ended)->info->id,
                  number::decimal(*outside));
  std::erase_if(one.methods, ends_there);
}

void Eval::add_rows(CurveCase<Kernel<double>> one, CurveTable& table) const {
  const auto curve = one.curve.view();
  const auto ts = finite_options("--t", t);
  require_points(ts, one);
  std::vector<reference::ExactPoint> truths;
  std::vector<reference::ExactPoint> p_tildes;
  reference::ExactCurve exact;
  for (const double at : ts) {
    truths.push_back(exact.point(curve, at));
    require_point(truths.back(), at, one.name);
    p_tildes.push_back(exact.p_tilde(curve, at));
  }
  std::vector<double> point(static_cast<std::size_t>(curve.dimension));
  for (const auto* kernel : one.methods)
    for (std::size_t k = 0; k < ts.size(); ++k) {
      PreparedState<double>(*kernel, curve).evaluate({&ts[k], 1}, point.data());
      table.add_point({std::string(kernel->info->id), number::decimal(ts[k])}, point, truths[k], p_tildes[k],
                      [&](int axis) -> std::optional<double> {
                        const auto& bound = kernel->info->bound;
                        if (!bound) return std::nullopt;
                        return reference::coordinate_bound(*bound, curve, axis, ts[k], truths[k].coordinate(axis));
                      });
    }
}

}  // namespace

extern constexpr CurveCommand curve_eval{"eval", "evaluate points of a curve", add_curve_command<Eval>};

}  // namespace bezierbench::cli
