// SPDX-License-Identifier: MIT
// `curve at-length`: the parameter at a length from the beginning of a curve by any method, against the true one.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "reference/length/length_along.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

using reference::LongReal;

struct AtLength {
  static constexpr Problem problem = Problem::inverse_arc_length;
  static std::vector<std::string> columns() {
    return {"method", "t", "iterations", "converged", "exact_t", "error", "error_estimate", "length_error"};
  }
  static auto kernels(int dimension) { return inverse_arc_length_kernels(dimension); }

  void add_to(Command command) {
    auto target = command.alternatives("position", "the position, by length or by fraction");
    target.option("--length", length, "length from the start, in coordinate units");
    target.option("--fraction", fraction, "fraction of the length of the curve, from 0 to 1");
    command.option("--tolerance", tolerance, "tolerance relative to the length of the curve; default: 1e-9");
  }
  void add_rows(const CurveCase<InverseArcLengthKernel>& one, CurveTable& table) const;

  std::string length;
  std::string fraction;
  std::string tolerance = "1e-9";
  TruthOption truth;
};

/// The requested length, exactly. A length that exceeds that of the whole curve by at most the tolerance, as a computed
/// length may, is the length of the whole curve.
LongReal target_of(const AtLength& asked, double tolerance, const LongReal& whole, const std::string& name) {
  if (!asked.fraction.empty()) {
    const double fraction = finite_option("--fraction", asked.fraction);
    if (fraction < 0 || fraction > 1 + tolerance)
      throw Failure(Exit::usage, fmt::format("--fraction {}: must be within 0 and 1", asked.fraction));
    return std::min(fraction, 1.0) * whole;
  }
  const double length = finite_option("--length", asked.length);
  if (length < 0 || LongReal(length) > whole * (1 + LongReal(tolerance)))
    throw Failure(Exit::usage, fmt::format("--length {}: must be within 0 and {}, the length of the curve in {}",
                                           asked.length, whole.str(17, std::ios_base::fmtflags{}), name));
  return LongReal(length) < whole ? LongReal(length) : whole;
}

using TrueLengths = std::optional<reference::LengthAlong<LongReal>>;

/// The fields `error` and `length_error` for a method's t. Where the length up to t has no error, t counts as exact.
std::array<std::string, 2> errors_of(const TrueLengths& lengths, double t, const LongReal& length,
                                     const std::optional<LongReal>& exact_t) {
  if (!lengths) return {};
  if (!std::isfinite(t)) return {"inf", "inf"};
  const LongReal of_length = lengths->distance(LongReal(t), length);
  const bool on_curve = t >= 0 && t <= 1;
  const std::string length_error = number::decimal(of_length.convert_to<double>());
  if (!exact_t) return {"", length_error};
  const LongReal of_t = on_curve && of_length == 0 ? LongReal(0) : LongReal(abs(LongReal(t) - *exact_t));
  return {number::decimal(of_t.convert_to<double>()), length_error};
}

void AtLength::add_rows(const CurveCase<InverseArcLengthKernel>& one, CurveTable& table) const {
  const auto curve = one.curve.view();
  const double relative = relative_tolerance(tolerance);
  TrueLengths
      lengths;  // empty where they are not certain to 30 digits, or take too long; results are printed in any case
  LongReal whole;
  try {
    whole = truth.finishes(one.name, curve.degree, [&] { lengths.emplace(curve); }) ? lengths->whole()
                                                                                    : whole_length(curve);
  } catch (const reference::NotCertain& error) {
    whole = error.length();
    fmt::print(stderr, "bezierbench: {}: {}; exact_t, error and length_error are left empty\n", one.name, error.what());
  }
  const LongReal target = target_of(*this, relative, whole, one.name);
  const auto exact_t = lengths ? lengths->known_parameter_at(target) : std::nullopt;
  for (const auto* method : one.methods) {
    const auto result = method->solve(curve, target.convert_to<double>(), relative);
    const auto [error, length_error] = errors_of(lengths, result.t, target, exact_t);
    table.add_row({std::string(method->info->id), number::decimal(result.t), std::to_string(result.iterations),
                   result.converged ? "yes" : "no", exact_t ? number::decimal(exact_t->convert_to<double>()) : "",
                   error, number::decimal(result.error_estimate), length_error});
  }
}

}  // namespace

extern constexpr CurveCommand curve_at_length{
    "at-length", "find the parameter at a given length from the start of a curve", add_curve_command<AtLength>};

}  // namespace bezierbench::cli
