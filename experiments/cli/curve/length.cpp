// SPDX-License-Identifier: MIT
// `curve length`: the length of a curve or of a part by any method, against the true one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/curve_table.hpp"
#include "experiments/cli/curve/truth_option.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/number/number.hpp"
#include "reference/length/true_length.hpp"

namespace bezierbench::cli {
namespace {

constexpr int exact_digits = 30;

struct LengthOptions {
  CurveOptions curve;
  std::string from = "0";
  std::string to = "1";
  std::string tolerance = "1e-9";
  std::vector<std::string> methods;
  TruthOption truth;
};

/// The part of the curve to measure, and the tolerance.
struct Task {
  double from;
  double to;
  double tolerance;
};

Task task_of(const LengthOptions& options) {
  Task task{finite_option("--from", options.from), finite_option("--to", options.to),
            finite_option("--tolerance", options.tolerance)};
  if (task.tolerance <= 0)
    throw Failure(Exit::usage,
                  fmt::format("--tolerance {}: must be above 0; it is relative to the length", options.tolerance));
  if (task.from < -task.tolerance || task.to > 1 + task.tolerance || task.from > task.to)
    throw Failure(Exit::usage,
                  fmt::format("--from {} --to {}: must be in order and within 0 and 1", options.from, options.to));
  // A computed parameter of an end, as `at-length` prints it, may be outside by the tolerance.
  task.from = std::clamp(task.from, 0.0, 1.0);
  task.to = std::clamp(task.to, 0.0, 1.0);
  return task;
}

/// The true length. Where it is not certain or takes too long: empty, with a line on standard error. The methods' results
/// are printed in any case.
std::optional<reference::TrueLength> true_length(const LengthOptions& options, const CurveView<double>& curve,
                                                 const Task& task) {
  std::optional<reference::TrueLength> length;
  try {
    (void)options.truth.finishes(options.curve.file, curve.degree, [&] { length.emplace(curve, task.from, task.to); });
  } catch (const reference::NotCertain& error) {
    fmt::print(stderr, "bezierbench: {}: {}; exact and error are left empty\n", options.curve.file, error.what());
  }
  return length;
}

void measure(const LengthOptions& options, const CurveFile& curve, CurveTable& table) {
  const auto task = task_of(options);
  const auto kernels = judge::arc_length_methods(curve.dimension);
  const auto methods = chosen(kernels, options.methods, curve, ids_in(kernels));
  if (methods.empty()) refuse_curve(options.curve.file, curve, *kernels.front().info);
  const auto truth = true_length(options, curve.view(), task);
  for (const auto* method : methods) {
    const auto result = method->measure(curve.view(), task.from, task.to, task.tolerance);
    table.add_row({std::string(method->info->id), number::decimal(result.length),
                   std::isnan(result.error_estimate) ? "" : number::decimal(result.error_estimate),
                   std::to_string(result.evaluations), result.converged ? "yes" : "no",
                   truth ? truth->decimal(exact_digits) : "",
                   truth ? number::decimal(truth->error_of(result.length)) : ""});
  }
}

}  // namespace

void add_curve_length(Command curve) {
  auto options = std::make_shared<LengthOptions>();
  auto command = curve.command("length", "compute the arc length of a curve or of a part of it");
  options->curve.add_to(command);
  command.option("--from", options->from, "parameter where the part starts; default: 0").takes("T");
  command.option("--to", options->to, "parameter where the part ends; default: 1").takes("T");
  command.option("--tolerance", options->tolerance, "tolerance relative to the length; default: 1e-9");
  command.option("--method", options->methods, "method id; may be repeated; default: all")
      .takes("METHOD", methods_of(Problem::arc_length));
  options->truth.add_to(command);
  command.action([options] {
    print_rows_of_curves(*options, {"method", "length", "error_estimate", "evaluations", "converged", "exact", "error"},
                         measure);
  });
}

}  // namespace bezierbench::cli
