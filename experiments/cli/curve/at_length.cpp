// SPDX-License-Identifier: MIT
// `curve at-length`: the parameters at lengths from the beginning of a curve or a path by any method, against the
// true ones.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "reference/length/length_truth.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

using reference::LongReal;

struct AtLength {
  static constexpr Problem problem = Problem::inverse_arc_length;
  static std::vector<std::string> columns(int dimension) {
    return with_axes({"method", "t", "iterations", "converged", "exact_t", "error", "error_estimate", "length_error"},
                     dimension);
  }
  static std::vector<std::string> path_columns(int dimension) {
    auto names = columns(dimension);
    names.insert(names.begin() + 1, "segment");
    return names;
  }
  static auto kernels(int dimension) { return inverse_arc_length_kernels(dimension); }

  void add_to(Command command) {
    auto target = command.alternatives("position", "the positions, by length or by fraction; may be repeated");
    target.option("--length", lengths, "length from the start, in coordinate units").takes("LENGTH");
    target.option("--fraction", fractions, "fraction of the length of the curve, from 0 to 1").takes("FRACTION");
    command.option("--tolerance", tolerance, "tolerance relative to the length of the curve; default: 1e-9");
  }
  [[nodiscard]] std::size_t questions() const { return lengths.size() + fractions.size(); }
  void add_rows(const CurveCase<InverseArcLengthKernel>& one, CurveTable& table) const {
    add_answers({&one, 1}, false, table);
  }
  void add_path_rows(std::span<const CurveCase<InverseArcLengthKernel>> segments, CurveTable& table) const {
    add_answers(segments, true, table);
  }

  std::vector<std::string> lengths;
  std::vector<std::string> fractions;
  std::string tolerance = "1e-9";
  TruthOption truth;

 private:
  void add_answers(std::span<const CurveCase<InverseArcLengthKernel>> segments, bool path, CurveTable& table) const;
  [[nodiscard]] LongReal target(std::size_t question, double tolerance, const LongReal& whole,
                                const std::string& name) const;
};

/// The requested length, exactly. A length that exceeds that of the whole curve by at most the tolerance, as a computed
/// length may, is the length of the whole curve.
LongReal AtLength::target(std::size_t question, double relative, const LongReal& whole, const std::string& name) const {
  if (!fractions.empty()) {
    const auto& text = fractions[question];
    const double fraction = finite_option("--fraction", text);
    if (fraction < 0 || fraction > 1 + relative)
      throw Failure(Exit::usage, "--fraction {}: must be within 0 and 1", text);
    return std::min(fraction, 1.0) * whole;
  }
  const auto& text = lengths[question];
  const double length = finite_option("--length", text);
  if (length < 0 || LongReal(length) > whole * (1 + LongReal(relative)))
    throw Failure(Exit::usage, "--length {}: must be within 0 and {}, the length of the curve in {}", text,
                  whole.str(17, std::ios_base::fmtflags{}), name);
  return LongReal(length) < whole ? LongReal(length) : whole;
}

/// A segment with its length. `lengths` is empty where they are not certain to 30 digits, or take too long; the length
/// is known to fewer digits then.
struct MeasuredSegment {
  CurveView<double> curve;
  std::optional<reference::LengthAlong<LongReal>> lengths;
  LongReal whole;
};

MeasuredSegment measured_segment(const CurveCase<InverseArcLengthKernel>& one, const TruthOption& truth) {
  MeasuredSegment segment{one.curve.view(), {}, {}};
  refuse_pole(segment.curve, 0, 1, one.name);
  try {
    const bool finished =
        truth.finishes(one.name, segment.curve.degree, [&] { segment.lengths.emplace(segment.curve); });
    segment.whole = finished ? segment.lengths->whole() : whole_length(segment.curve);
  } catch (const reference::NotCertain& error) {
    if (!error.has_digits()) throw Failure(Exit::input_output, "{}: {}; choose another curve", one.name, error.what());
    segment.whole = error.length();
    fmt::print(stderr, "bezierbench: {}: {}; exact_t, error and length_error are left empty\n", one.name, error.what());
  }
  return segment;
}

/// The fields `error` and `length_error` for a method's t. Where the length up to t has no error, t counts as exact.
std::array<std::string, 2> errors_of(const MeasuredSegment& segment, double t, const LongReal& length,
                                     const std::optional<LongReal>& exact_t) {
  if (!segment.lengths) return {};
  if (!std::isfinite(t)) return {"inf", "inf"};
  const LongReal of_length = segment.lengths->distance(LongReal(t), length);
  const bool on_curve = t >= 0 && t <= 1;
  const std::string length_error = number::decimal(of_length.convert_to<double>());
  if (!exact_t) return {"", length_error};
  const LongReal of_t = on_curve && of_length == 0 ? LongReal(0) : LongReal(abs(LongReal(t) - *exact_t));
  return {number::decimal(of_t.convert_to<double>()), length_error};
}

/// A position on a path: a segment, and a length from its start.
struct PathPosition {
  std::size_t segment;
  LongReal length;
  std::optional<LongReal> exact_t;
};

/// The position at a length from the start of the path: in the first segment that reaches so far.
PathPosition path_position(const std::vector<MeasuredSegment>& segments, LongReal length) {
  std::size_t k = 0;
  for (; k + 1 < segments.size() && length > segments[k].whole; ++k) length -= segments[k].whole;
  const auto& lengths = segments[k].lengths;
  return {k, length, lengths ? lengths->known_parameter_at(length) : std::nullopt};
}

void AtLength::add_answers(std::span<const CurveCase<InverseArcLengthKernel>> segments, bool path,
                           CurveTable& table) const {
  const double relative = relative_tolerance(tolerance);
  std::vector<MeasuredSegment> all;
  LongReal whole = 0;
  for (const auto& one : segments) {
    all.push_back(measured_segment(one, truth));
    whole += all.back().whole;
  }
  std::vector<PathPosition> positions;
  for (std::size_t k = 0; k < questions(); ++k)
    positions.push_back(path_position(all, target(k, relative, whole, segments.front().name)));
  for (std::size_t m = 0; m < segments.front().methods.size(); ++m)
    for (std::size_t k = 0; k < questions(); ++k) {
      const auto& [at, length, exact_t] = positions[k];
      const auto& segment = all[at];
      const auto* method = segments[at].methods[m];
      const auto result = method->solve(segment.curve, length.convert_to<double>(), relative);
      const auto [error, length_error] = errors_of(segment, result.t, length, exact_t);
      std::vector<std::string> row{std::string(method->info->id)};
      if (path) row.push_back(std::to_string(at));
      for (auto& field : std::vector<std::string>{number::decimal(result.t), std::to_string(result.iterations),
                                                  result.converged ? "yes" : "no",
                                                  exact_t ? number::decimal(exact_t->convert_to<double>()) : "", error,
                                                  number::decimal(result.error_estimate), length_error})
        row.push_back(std::move(field));
      table.add_row(std::move(row), k, point_fields_at(segment.curve, result.t, segments[at].dimension));
    }
}

}  // namespace

extern constexpr CurveCommand curve_at_length{
    "at-length", "find the parameters at given lengths from the start of a curve", add_curve_command<AtLength>};

}  // namespace bezierbench::cli
