// SPDX-License-Identifier: MIT
// Studies of kind `flattening`: random curves and those of sets as chords within each tolerance. Whether a piece is
// within the tolerance of its chord is proved or refuted, and the chords are compared with the least number of chords
// whose ends are on the curve.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "experiments/studies/flattening/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/error/norm.hpp"

namespace bezierbench::studies {
namespace {

/// The ends of chords lead from the first control point to the last one, with ascending parameters.
bool is_polyline(const CurveView<double>& curve, const Flattening& chords) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  return chords.t.size() >= 2 && chords.points.size() == chords.t.size() * d && chords.t.front() == 0 &&
         chords.t.back() == 1 && std::ranges::is_sorted(chords.t) &&
         std::ranges::equal(std::span(chords.points).first(d), curve.coefficients.first(d)) &&
         std::ranges::equal(std::span(chords.points).last(d), curve.coefficients.last(d));
}

/// Of all chords.
struct Judgement {
  reference::Enclosure distance{0, 0};
  bool refuted = false;
  bool proved = true;
};

Judgement judge_chords(const FlatteningProblem::Drawn& drawn, const Flattening& chords, double tolerance) {
  const auto d = static_cast<std::size_t>(drawn.curve.dimension);
  const auto point = [&](std::size_t k) { return std::span(chords.points).subspan(k * d, d); };
  Judgement all;
  for (std::size_t k = 0; k + 1 < chords.t.size(); ++k) {
    const auto [distance, kept] =
        reference::judge_chord(*drawn.scaled, chords.t[k], chords.t[k + 1], point(k), point(k + 1), tolerance);
    all.distance.low = std::max(all.distance.low, distance.low);
    all.distance.high = std::max(all.distance.high, distance.high);
    all.refuted = all.refuted || kept == reference::Kept::refuted;
    all.proved = all.proved && kept == reference::Kept::proved;
  }
  return all;
}

/// Whether the points of the reversed curve are the reversed ones, bit for bit.
bool are_reversed(const Flattening& chords, const Flattening& reversed, std::size_t dimension) {
  if (chords.points.size() != reversed.points.size()) return false;
  for (std::size_t k = 0, last = chords.points.size(); k < last; k += dimension)
    if (std::memcmp(&chords.points[k], &reversed.points[last - dimension - k], dimension * sizeof(double)) != 0)
      return false;
  return true;
}

}  // namespace

void FlatteningProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  const auto& curve = drawn.curve;
  const auto d = static_cast<std::size_t>(curve.dimension);
  drawn.size = 0;
  double largest = 0;
  for (int axis = 0; axis < curve.dimension; ++axis) {
    double low = curve(axis, 0);
    double high = low;
    for (int i = 1; i <= curve.degree; ++i) {
      low = std::min(low, curve(axis, i));
      high = std::max(high, curve(axis, i));
    }
    drawn.size = std::max(drawn.size, high - low);
    largest = std::max({largest, std::abs(low), std::abs(high)});
  }
  if (drawn.size == 0) drawn.size = largest > 0 ? largest : 1;
  drawn.reversed.clear();
  for (std::size_t k = curve.coefficients.size(); k > 0; k -= d)
    for (std::size_t axis = 0; axis < d; ++axis) drawn.reversed.push_back(curve.coefficients[k - d + axis]);
  drawn.reversed_weights.assign(curve.weights.rbegin(), curve.weights.rend());
  drawn.scaled.emplace(curve);
  drawn.least_for = 0;
}

void FlatteningProblem::judge(const Kernel& method, Drawn& drawn, double tolerance, const Answer& chords,
                              std::uint64_t number, Errors& errors) {
  if (!reference::all_finite(chords.t) || !reference::all_finite(chords.points)) {
    ++errors.non_finite;
    return;
  }
  if (!is_polyline(drawn.curve, chords)) {
    errors.malformed.add(number);
    return;
  }
  const double absolute = tolerance * drawn.size;
  if (drawn.least_for != tolerance) {
    drawn.least = reference::least_chords(*drawn.scaled, absolute);
    drawn.least_for = tolerance;
  }
  const std::uint64_t count = chords.t.size() - 1;
  errors.chords.add(count);
  errors.least_low.add(static_cast<std::uint64_t>(drawn.least.low));
  errors.least_high.add(static_cast<std::uint64_t>(drawn.least.high));
  metric::add_rounded(static_cast<double>(count) / drawn.least.low, errors.over_least);
  errors.evaluations.add(static_cast<std::uint64_t>(chords.evaluations));
  errors.incomplete += chords.complete ? 0 : 1;
  const auto judgement = judge_chords(drawn, chords, absolute);
  metric::add_rounded(judgement.distance.high / absolute, errors.error);
  if (judgement.refuted) {
    errors.broken.add(number);
    if (method.keeps_tolerance && chords.complete) errors.broken_promises.add(number);
    std::vector<double> numbers(drawn.curve.coefficients.begin(), drawn.curve.coefficients.end());
    numbers.insert(numbers.end(), drawn.curve.weights.begin(), drawn.curve.weights.end());
    errors.worst.merge({judgement.distance.low / absolute, number, std::move(numbers)});
  } else if (!judgement.proved) {
    errors.undecided.add(number);
  }
  auto curve = drawn.curve;
  curve.coefficients = drawn.reversed;
  curve.weights = drawn.reversed_weights;
  Flattening reversed;
  method.flatten(curve, absolute, reversed);
  if (are_reversed(chords, reversed, static_cast<std::size_t>(curve.dimension))) return;
  errors.reversed_apart.add(number);
  if (method.reverses) errors.broken_reversals.add(number);
}

bool FlatteningProblem::is_right(const Kernel& /*method*/, const Drawn& drawn, double tolerance, const Answer& chords) {
  return reference::all_finite(chords.t) && reference::all_finite(chords.points) && is_polyline(drawn.curve, chords) &&
         !judge_chords(drawn, chords, tolerance * drawn.size).refuted;
}

tables::Field worst_curve(const FlatteningErrors& errors) {
  std::string text;
  for (const double number : errors.worst.numbers)
    text += (text.empty() ? "" : " ") + tables::text(tables::Hexadecimal{number});
  return tables::field(text);
}

namespace {

constexpr std::array flattening_fields{suite::field<&suite::Study::tolerance>(
    suite::tolerance_key("tolerances that the methods are given, relative to the size of the curve", "[1e-2, 1e-4]"))};

}  // namespace

extern constexpr StudyKind flattening_kind =
    companion_kind<FlatteningProblem>({.id = "flattening",
                                       .about = "chords within a tolerance: whether it is kept, and how many there are",
                                       .own = flattening_fields,
                                       .methods_example = "[\"wang_count\"]",
                                       .inputs = {.forms = suite::forms_with_control_points,
                                                  .forms_reason = "what is flattened are curves with control points",
                                                  .double_only = true,
                                                  .least_degree = 1,
                                                  .least_degree_reason = "a chord has two ends",
                                                  .parameters = suite::Parameters::whole,
                                                  .parameters_reason = "whole curves are flattened"}});

}  // namespace bezierbench::studies
