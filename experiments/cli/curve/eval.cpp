// SPDX-License-Identifier: MIT
// `curve eval`: points of one curve by any method, against the exact ones.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/curve_table.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/workspace.hpp"
#include "experiments/number/number.hpp"
#include "reference/error/coordinate_error.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::cli {
namespace {

struct EvalOptions {
  CurveOptions curve;
  std::vector<std::string> t;
  std::vector<std::string> methods;
};

/// The field of the column bound_u for one axis.
std::string bound_of(const MethodInfo& info, const CurveFile& curve, int axis, double t,
                     const reference::Rational& truth, const reference::Rational& p_tilde) {
  if (!info.bound) return "";
  return bound_field(reference::coordinate_bound(*info.bound, curve.view(), axis, t, truth), p_tilde);
}

/// The methods that chosen() returns, without those that have no point at some t. Throws Failure(usage) for a method
/// that is named and has none.
std::vector<const Kernel<double>*> chosen_for(const std::vector<double>& ts, const EvalOptions& options,
                                              const CurveFile& curve) {
  auto methods = chosen(judge::methods<double>(curve.dimension), options.methods, curve, vocabulary().methods);
  const auto outside = std::ranges::find_if(ts, [](double t) { return t < 0 || t > 1; });
  if (outside == ts.end()) return methods;
  const auto ends_there = [](const auto* kernel) { return kernel->info->unit_interval_only; };
  const auto ended = std::ranges::find_if(methods, ends_there);
  if (!options.methods.empty() && ended != methods.end())
    throw Failure(Exit::usage, fmt::format("--method {}: takes t in [0,1] only, --t is {}; see `list methods`",
                                           (*ended)->info->id, number::decimal(*outside)));
  std::erase_if(methods, ends_there);
  return methods;
}

void evaluate(const EvalOptions& options, const CurveFile& curve, CurveTable& table) {
  std::vector<double> ts;
  for (const auto& text : options.t) ts.push_back(finite_option("--t", text));
  const auto methods = chosen_for(ts, options, curve);
  std::vector<reference::ExactPoint> truths;
  std::vector<reference::ExactPoint> p_tildes;
  reference::ExactCurve exact;
  for (const double t : ts) {
    truths.push_back(exact.point(curve.view(), t));
    if (!truths.back().exists())
      throw Failure(Exit::usage,
                    fmt::format("--t {}: the weights of {} sum to zero there, so the curve has no point; see "
                                "column w or choose another t",
                                number::decimal(t), options.curve.file));
    p_tildes.push_back(exact.p_tilde(curve.view(), t));
  }
  judge::PreparedStorage storage;
  std::vector<double> point(static_cast<std::size_t>(curve.dimension));
  for (const auto* kernel : methods)
    for (std::size_t k = 0; k < ts.size(); ++k) {
      judge::evaluate_once<double>(*kernel, curve.view(), ts[k], storage, point);
      for (int axis = 0; axis < curve.dimension; ++axis) {
        std::vector<std::string> row{std::string(kernel->info->id), number::decimal(ts[k]), axis_name(axis)};
        for (auto& field : judged_coordinate(point[static_cast<std::size_t>(axis)], truths[k].coordinate(axis),
                                             p_tildes[k].coordinate(axis)))
          row.push_back(std::move(field));
        row.push_back(
            bound_of(*kernel->info, curve, axis, ts[k], truths[k].coordinate(axis), p_tildes[k].coordinate(axis)));
        table.add_row(std::move(row));
      }
    }
}

}  // namespace

void add_curve_eval(Command curve) {
  auto options = std::make_shared<EvalOptions>();
  auto command = curve.command("eval", "evaluate points of a curve");
  options->curve.add_to(command);
  command.option("--t", options->t, "parameter; may be repeated").required().takes("T");
  command.option("--method", options->methods, "method id; may be repeated; default: all that apply")
      .takes("METHOD", methods_of(Problem::evaluation));
  command.action([options] {
    print_rows_of_curves(
        *options, {"method", "t", "axis", "value", "exact", "error", "error_ulp", "error_u", "bound_u"}, evaluate);
  });
}

}  // namespace bezierbench::cli
