// SPDX-License-Identifier: MIT
// Studies of kind `subdivision`: random curves split at random t; every control point of both halves is judged against
// the exact one.
#include <algorithm>
#include <bit>
#include <cmath>

#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/subdivision/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "reference/error/norm.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::studies {
namespace {

/// Whether the numbers have the same bits; 0 and -0 differ.
bool same_bits(std::span<const double> a, std::span<const double> b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

/// Whether control point `i` of a half has the bits of control point `i` of the curve.
bool is_end(const CurveView<double>& curve, const ComputedHalves& computed, Side side, int i) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  const auto k = static_cast<std::size_t>(i);
  const auto control = computed.control(side, i);
  return same_bits(control.first(d), curve.coefficients.subspan(k * d, d)) &&
         (curve.form != Form::rational || same_bits(control.last(1), curve.weights.subspan(k, 1)));
}

/// Adds the errors of a control point. Returns whether they are within the proved bounds.
bool judge_control(const SplitKernel& method, const CurveView<double>& curve, const SplitTruth& truth, Side side, int i,
                   std::span<const double> control, SubdivisionErrors& errors) {
  const auto point = truth.point_error(method.bound, side, i, control.first(static_cast<std::size_t>(curve.dimension)));
  metric::add_rounded(point.error, errors.error);
  metric::add_rounded(point.error_u, errors.error_u);
  if (std::isfinite(point.bound)) ++errors.bounded;
  if (std::isfinite(point.bound_u)) errors.bound_u.add(point.bound_u);
  bool kept = !reference::TrialScale::violates(point.error, point.bound);
  if (curve.form == Form::rational) {
    const auto weight = truth.weight_error(method.bound, side, i, control.back());
    errors.weight_error_u.add(weight.error_u);
    kept = kept && !reference::TrialScale::violates(weight.error, weight.bound);
  }
  return kept;
}

/// Whether a control point that is not finite has a proved bound.
bool breaks_bound(const SplitKernel& method, const CurveView<double>& curve, const SplitTruth& truth,
                  const ComputedHalves& computed) {
  for (const Side side : sides)
    for (int i = 0; i <= curve.degree; ++i) {
      const auto control = computed.control(side, i);
      const auto point = control.first(static_cast<std::size_t>(curve.dimension));
      if (!reference::all_finite(control) && std::isfinite(truth.point_error(method.bound, side, i, point).bound))
        return true;
    }
  return false;
}

/// Judges the junction and the ends, which needs no truth. Promises hold for t in [0,1].
void judge_bits(const SplitKernel& method, const CurveView<double>& curve, double t, const ComputedHalves& computed,
                std::uint64_t trial, SubdivisionErrors& errors) {
  const int n = curve.degree;
  const bool shared = same_bits(computed.control(Side::left, n), computed.control(Side::right, 0));
  const bool kept = is_end(curve, computed, Side::left, 0) && is_end(curve, computed, Side::right, n);
  if (!shared) errors.junctions_apart.add(trial);
  if (!kept) errors.ends_moved.add(trial);
  const bool broken = (method.promises->shares_junction && !shared) || (method.promises->keeps_ends && !kept);
  if (broken && t >= 0 && t <= 1) errors.broken_promises.add(trial);
}

bool near_enough(const SplitError& error) {
  return std::isfinite(error.bound) ? !reference::TrialScale::violates(error.error, error.bound)
                                    : error.error_u <= judge::half_of_the_digits;
}

}  // namespace

void SubdivisionProblem::judge(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer,
                               std::uint64_t number, Errors& errors) {
  const CurveView<double>& curve = drawn.curve;
  const ComputedHalves computed(curve, answer);
  if (!computed.all_finite()) {
    ++errors.non_finite;
    if (breaks_bound(method, curve, *drawn.truth, computed)) errors.violations.add(number);
    return;
  }
  bool kept = true;
  for (const Side side : sides)
    for (int i = 0; i <= curve.degree; ++i)
      kept = judge_control(method, curve, *drawn.truth, side, i, computed.control(side, i), errors) && kept;
  if (!kept) errors.violations.add(number);
  judge_bits(method, curve, drawn.trial.t, computed, number, errors);
  if (method.bound == nullptr || method.bound->amplification != SplitAmplification::p_tilde) return;
  ++errors.middles;
  if (!drawn.truth->middles_agree(method.bound, computed)) errors.points_off.add(number);
}

bool SubdivisionProblem::is_right(const Kernel& method, const Drawn& drawn, double /*tolerance*/,
                                  const Answer& answer) {
  const CurveView<double>& curve = drawn.curve;
  const ComputedHalves computed(curve, answer);
  if (!computed.all_finite()) return false;
  bool right = true;
  for (const Side side : sides)
    for (int i = 0; i <= curve.degree; ++i) {
      const auto control = computed.control(side, i);
      const auto point = control.first(static_cast<std::size_t>(curve.dimension));
      right = right && near_enough(drawn.truth->point_error(method.bound, side, i, point));
      if (curve.form == Form::rational)
        right = right && near_enough(drawn.truth->weight_error(method.bound, side, i, control.back()));
    }
  return right;
}

extern constexpr StudyKind subdivision_kind =
    companion_kind<SubdivisionProblem>({.id = "subdivision",
                                        .about = "errors of the control points of both halves of a split curve",
                                        .own = {},
                                        .methods_example = "[\"de_casteljau_split\"]",
                                        .inputs = {.forms = suite::forms_with_control_points,
                                                   .forms_reason = "what is split has control points",
                                                   .double_only = true}});

}  // namespace bezierbench::studies
