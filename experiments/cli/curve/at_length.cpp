// SPDX-License-Identifier: MIT
// `curve at-length`: the parameter at a length from the beginning of a curve by any method, against the true one.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/curve/curve_table.hpp"
#include "experiments/cli/curve/truth_option.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/number/number.hpp"
#include "reference/length/length_along.hpp"

namespace bezierbench::cli {
namespace {

using reference::LongReal;

struct AtLengthOptions {
  CurveOptions curve;
  std::string length;
  std::string fraction;
  std::string tolerance = "1e-9";
  std::vector<std::string> methods;
  TruthOption truth;
};

double tolerance_of(const AtLengthOptions& options) {
  const double tolerance = finite_option("--tolerance", options.tolerance);
  if (tolerance <= 0)
    throw Failure(Exit::usage, fmt::format("--tolerance {}: must be above 0; it is relative to the length of the curve",
                                           options.tolerance));
  return tolerance;
}

/// The requested length, exactly. A length that exceeds that of the whole curve by at most the tolerance, as a computed
/// length may, is the length of the whole curve.
LongReal target_of(const AtLengthOptions& options, double tolerance, const LongReal& whole) {
  if (!options.fraction.empty()) {
    const double fraction = finite_option("--fraction", options.fraction);
    if (fraction < 0 || fraction > 1 + tolerance)
      throw Failure(Exit::usage, fmt::format("--fraction {}: must be within 0 and 1", options.fraction));
    return std::min(fraction, 1.0) * whole;
  }
  const double length = finite_option("--length", options.length);
  if (length < 0 || LongReal(length) > whole * (1 + LongReal(tolerance)))
    throw Failure(Exit::usage,
                  fmt::format("--length {}: must be within 0 and {}, the length of the curve in {}", options.length,
                              whole.str(17, std::ios_base::fmtflags{}), options.curve.file));
  return LongReal(length) < whole ? LongReal(length) : whole;
}

/// The true lengths along a curve; empty where they are not certain to 30 digits, or take too long.
class Truth {
 public:
  /// Prints a line on standard error where there are none. The results of the methods are printed in any case.
  Truth(const AtLengthOptions& options, const CurveView<double>& curve) {
    try {
      if (options.truth.finishes(options.curve.file, curve.degree, [&] { lengths_.emplace(curve); }))
        whole_ = lengths_->whole();
      else
        whole_ = whole_length(curve);
    } catch (const reference::NotCertain& error) {
      whole_ = error.length();
      fmt::print(stderr, "bezierbench: {}: {}; exact_t, error and length_error are left empty\n", options.curve.file,
                 error.what());
    }
  }

  [[nodiscard]] const LongReal& whole() const { return whole_; }

  /// Empty where its last digits are not known.
  [[nodiscard]] std::optional<LongReal> parameter_at(const LongReal& length) const {
    if (!lengths_) return std::nullopt;
    return lengths_->known_parameter_at(length);
  }

  /// The fields `error` and `length_error` for a method's t. Where the length up to t has no error, t counts as exact.
  [[nodiscard]] std::array<std::string, 2> errors(double t, const LongReal& length,
                                                  const std::optional<LongReal>& exact_t) const {
    if (!lengths_) return {};
    if (!std::isfinite(t)) return {"inf", "inf"};
    const LongReal of_length = lengths_->distance(LongReal(t), length);
    const bool on_curve = t >= 0 && t <= 1;
    const std::string length_error = number::decimal(of_length.convert_to<double>());
    if (!exact_t) return {"", length_error};
    const LongReal of_t = on_curve && of_length == 0 ? LongReal(0) : LongReal(abs(LongReal(t) - *exact_t));
    return {number::decimal(of_t.convert_to<double>()), length_error};
  }

 private:
  std::optional<reference::LengthAlong<LongReal>> lengths_;
  LongReal whole_;
};

void find(const AtLengthOptions& options, const CurveFile& curve, CurveTable& table) {
  const double tolerance = tolerance_of(options);
  const auto methods =
      chosen(inverse_arc_length_kernels(curve.dimension), options.methods, curve, ids_of(inverse_arc_length_infos()));
  if (methods.empty()) refuse_curve(options.curve.file, curve, *inverse_arc_length_infos().front());
  const Truth truth(options, curve.view());
  const LongReal target = target_of(options, tolerance, truth.whole());
  const auto exact_t = truth.parameter_at(target);
  for (const auto* method : methods) {
    const auto result = method->solve(curve.view(), target.convert_to<double>(), tolerance);
    const auto [error, length_error] = truth.errors(result.t, target, exact_t);
    table.add_row({std::string(method->info->id), number::decimal(result.t), std::to_string(result.iterations),
                   result.converged ? "yes" : "no", exact_t ? number::decimal(exact_t->convert_to<double>()) : "",
                   error, number::decimal(result.error_estimate), length_error});
  }
}

}  // namespace

void add_curve_at_length(Command curve) {
  auto options = std::make_shared<AtLengthOptions>();
  auto command = curve.command("at-length", "find the parameter at a given length from the start of a curve");
  options->curve.add_to(command);
  auto target = command.alternatives("position", "the position, by length or by fraction");
  target.option("--length", options->length, "length from the start, in coordinate units");
  target.option("--fraction", options->fraction, "fraction of the length of the curve, from 0 to 1");
  command.option("--tolerance", options->tolerance, "tolerance relative to the length of the curve; default: 1e-9");
  command.option("--method", options->methods, "method id; may be repeated; default: all")
      .takes("METHOD", methods_of(Problem::inverse_arc_length));
  options->truth.add_to(command);
  command.action([options] {
    print_rows_of_curves(
        *options, {"method", "t", "iterations", "converged", "exact_t", "error", "error_estimate", "length_error"},
        find);
  });
}

}  // namespace bezierbench::cli
