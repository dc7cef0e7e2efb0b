// SPDX-License-Identifier: MIT
// `curve length`: the length of a curve or of a part by any method, against the true one.
#include <algorithm>
#include <cmath>

#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/judge/methods.hpp"
#include "reference/length/true_length.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

constexpr int exact_digits = 30;

struct Length {
  static constexpr Problem problem = Problem::arc_length;
  static std::vector<std::string> columns() {
    return {"method", "length", "error_estimate", "evaluations", "converged", "exact", "error"};
  }
  static auto kernels(int dimension) { return judge::arc_length_methods(dimension); }

  void add_to(Command command) {
    command.option("--from", from, "parameter where the part starts; default: 0").takes("T");
    command.option("--to", to, "parameter where the part ends; default: 1").takes("T");
    command.option("--tolerance", tolerance, "tolerance relative to the length; default: 1e-9");
  }
  void add_rows(const CurveCase<ArcLengthKernel>& one, CurveTable& table) const;

  std::string from = "0";
  std::string to = "1";
  std::string tolerance = "1e-9";
  TruthOption truth;
};

void Length::add_rows(const CurveCase<ArcLengthKernel>& one, CurveTable& table) const {
  const auto curve = one.curve.view();
  const double relative = relative_tolerance(tolerance);
  const double first = finite_option("--from", from);
  const double last = finite_option("--to", to);
  if (first < -relative || last > 1 + relative || first > last)
    throw Failure(Exit::usage, fmt::format("--from {} --to {}: must be in order and within 0 and 1", from, to));
  // A computed parameter of an end, as `at-length` prints it, may be outside by the tolerance.
  const double a = std::clamp(first, 0.0, 1.0);
  const double b = std::clamp(last, 0.0, 1.0);
  std::optional<reference::TrueLength> exact;  // the methods' results are printed without it, too
  try {
    (void)truth.finishes(one.name, curve.degree, [&] { exact.emplace(curve, a, b); });
  } catch (const reference::NotCertain& error) {
    fmt::print(stderr, "bezierbench: {}: {}; exact and error are left empty\n", one.name, error.what());
  }
  for (const auto* method : one.methods) {
    const auto result = method->measure(curve, a, b, relative);
    table.add_row({std::string(method->info->id), number::decimal(result.length),
                   std::isnan(result.error_estimate) ? "" : number::decimal(result.error_estimate),
                   std::to_string(result.evaluations), result.converged ? "yes" : "no",
                   exact ? exact->decimal(exact_digits) : "",
                   exact ? number::decimal(exact->error_of(result.length)) : ""});
  }
}

}  // namespace

extern constexpr CurveCommand curve_length{"length", "compute the arc length of a curve or of a part of it",
                                           add_curve_command<Length>};

}  // namespace bezierbench::cli
