// SPDX-License-Identifier: MIT
// `curve length`: the length of a curve or of a part by any method, against the true one.
#include <algorithm>
#include <cmath>
#include <limits>

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
  void prepare(bool whole_path);
  void add_rows(const CurveCase<ArcLengthKernel>& one, CurveTable& table) const { add_answer({&one, 1}, table); }
  void add_path_rows(std::span<const CurveCase<ArcLengthKernel>> segments, CurveTable& table) const {
    add_answer(segments, table);
  }
  static std::vector<std::string> path_columns(int /*dimension*/) { return columns(); }

  std::string from = "0";
  std::string to = "1";
  std::string tolerance = "1e-9";
  TruthOption truth;

 private:
  void add_answer(std::span<const CurveCase<ArcLengthKernel>> segments, CurveTable& table) const;

  double relative_ = 0;
  double first_ = 0;
  double last_ = 1;
};

void Length::prepare(bool whole_path) {
  relative_ = relative_tolerance(tolerance);
  const double first = finite_option("--from", from);
  const double last = finite_option("--to", to);
  if (first < -relative_ || last > 1 + relative_ || first > last)
    throw Failure(Exit::usage, "--from {} --to {}: must be in order and within 0 and 1", from, to);
  // A computed parameter of an end, as `at-length` prints it, may be outside by the tolerance.
  first_ = std::clamp(first, 0.0, 1.0);
  last_ = std::clamp(last, 0.0, 1.0);
  if (whole_path && (first_ != 0 || last_ != 1))
    throw Failure(Exit::usage,
                  "--whole-path: takes no --from and --to, which are parameters of one curve; leave them out");
}

/// The true length of a curve or of all segments of a path.
struct PathLength {
  reference::LongReal value = 0;
  reference::LongReal uncertainty = 0;

  /// As TrueLength::error_of().
  [[nodiscard]] double error_of(double length) const {
    if (!std::isfinite(length)) return std::numeric_limits<double>::infinity();
    const reference::LongReal error = abs(reference::LongReal(length) - value);
    return error <= uncertainty ? 0 : error.convert_to<double>();
  }
};

void Length::add_answer(std::span<const CurveCase<ArcLengthKernel>> segments, CurveTable& table) const {
  std::optional<PathLength> exact = PathLength();  // the methods' results are printed without it, too
  for (const auto& one : segments) try {
      const auto curve = one.curve.view();
      refuse_pole(curve, first_, last_, one.name);
      std::optional<reference::TrueLength> length;
      const bool finished = truth.finishes(one.name, curve.degree, [&] { length.emplace(curve, first_, last_); });
      if (!finished) exact.reset();
      if (!exact) break;
      exact->value += length->value();
      exact->uncertainty += length->uncertainty();
    } catch (const reference::NotCertain& error) {
      fmt::print(stderr, "bezierbench: {}: {}; exact and error are left empty\n", one.name, error.what());
      exact.reset();
      break;
    }
  for (std::size_t m = 0; m < segments.front().methods.size(); ++m) {
    ArcLength sum{.error_estimate = 0, .converged = true};
    for (const auto& one : segments) {
      const auto part = one.methods[m]->measure(one.curve.view(), first_, last_, relative_);
      sum.length += part.length;
      sum.error_estimate += part.error_estimate;
      sum.evaluations += part.evaluations;
      sum.converged = sum.converged && part.converged;
    }
    table.add_row({std::string(segments.front().methods[m]->info->id), number::decimal(sum.length),
                   std::isnan(sum.error_estimate) ? "" : number::decimal(sum.error_estimate),
                   std::to_string(sum.evaluations), sum.converged ? "yes" : "no",
                   exact ? exact->value.str(exact_digits, std::ios_base::fmtflags{}) : "",
                   exact ? number::decimal(exact->error_of(sum.length)) : ""});
  }
}

}  // namespace

extern constexpr CurveCommand curve_length{"length", "compute the arc length of a curve or of a part of it",
                                           add_curve_command<Length>};

}  // namespace bezierbench::cli
