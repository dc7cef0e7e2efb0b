// SPDX-License-Identifier: MIT
// `curve flatten`: a curve as chords by any method, judged chord by chord, beside the least number of chords.
#include <algorithm>
#include <cmath>

#include "core/flatten/kernel.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "reference/companion/chord_distance.hpp"
#include "reference/curves/curve_set.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct Flatten {
  static constexpr Problem problem = Problem::flattening;
  static constexpr const char* control_points_help = "print the chords of the first method, as a set of curves";
  static std::vector<std::string> columns() {
    return {"method",        "chords", "least_low", "least_high", "distance_low",
            "distance_high", "kept",   "complete",  "evaluations"};
  }
  static auto kernels(int dimension) { return flatten_kernels(dimension); }

  void add_to(Command command) {
    command.option("--tolerance", tolerance, "farthest that the curve may be from its chord, in coordinate units")
        .takes("E")
        .required();
  }
  void prepare(bool /*whole_path*/) {
    tolerance_ = finite_option("--tolerance", tolerance);
    if (tolerance_ <= 0) throw Failure(Exit::usage, "--tolerance {}: must be above 0", echo(tolerance));
  }
  void add_rows(const CurveCase<FlattenKernel>& one, CurveTable& table) const;
  /// Adds the chords of the first method, as curves of degree 1 that make a path.
  void add_to_set(std::span<const CurveCase<FlattenKernel>> cases, const std::string& id, curves::CurveSet& set) const;

  std::string tolerance;
  bool control_points = false;

 private:
  double tolerance_ = 0;
};

void Flatten::add_rows(const CurveCase<FlattenKernel>& one, CurveTable& table) const {
  const auto curve = one.curve.view();
  const auto d = static_cast<std::size_t>(curve.dimension);
  refuse_pole(curve, 0, 1, one.name);
  const reference::ScaledCurve scaled(curve);
  const auto least = reference::least_chords(scaled, tolerance_);
  Flattening chords;
  for (const auto* method : one.methods) {
    method->flatten(curve, tolerance_, chords);
    const bool finite = std::ranges::all_of(chords.points, [](double x) { return std::isfinite(x); });
    reference::Enclosure distance{0, 0};
    auto kept = reference::Kept::proved;
    for (std::size_t k = 0; finite && k + 1 < chords.t.size(); ++k) {
      const auto end = [&](std::size_t i) { return std::span(chords.points).subspan(i * d, d); };
      const auto chord = reference::judge_chord(scaled, chords.t[k], chords.t[k + 1], end(k), end(k + 1), tolerance_);
      distance = {std::max(distance.low, chord.distance.low), std::max(distance.high, chord.distance.high)};
      if (kept != reference::Kept::refuted && chord.kept != reference::Kept::proved) kept = chord.kept;
    }
    const std::string_view verdict = !finite || kept == reference::Kept::refuted ? "no"
                                     : kept == reference::Kept::proved           ? "yes"
                                                                                 : "undecided";
    table.add_row({std::string(method->info->id), std::to_string(chords.t.size() - 1), std::to_string(least.low),
                   std::to_string(least.high), finite ? number::decimal(distance.low) : "",
                   finite ? number::decimal(distance.high) : "", std::string(verdict), chords.complete ? "yes" : "no",
                   std::to_string(chords.evaluations)});
  }
}

void Flatten::add_to_set(std::span<const CurveCase<FlattenKernel>> cases, const std::string& id,
                         curves::CurveSet& set) const {
  const auto& one = cases.front();
  refuse_pole(one.curve.view(), 0, 1, one.name);
  Flattening chords;
  one.methods.front()->flatten(one.curve.view(), tolerance_, chords);
  if (!std::ranges::all_of(chords.points, [](double x) { return std::isfinite(x); }))
    throw Failure(Exit::input_output,
                  "{}: a point of the chords is beyond the largest double; scale the coordinates down", one.name);
  const int dimension = one.curve.dimension;
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t k = 0; k + 1 < chords.t.size(); ++k)
    set.add(fmt::format("{}{}", id.empty() ? "" : id + ":", k),
            {Form::bernstein, dimension, 1, std::span(chords.points).subspan(k * d, 2 * d)}, k == 0);
}

}  // namespace

extern constexpr CurveCommand curve_flatten{"flatten", "turn a curve into chords within a tolerance",
                                            add_curve_command<Flatten>};

}  // namespace bezierbench::cli
