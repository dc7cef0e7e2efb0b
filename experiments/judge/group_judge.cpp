// SPDX-License-Identifier: MIT
#include "experiments/judge/group_judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "experiments/judge/error_sources.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/judge/trial_inputs.hpp"
#include "experiments/metric/scale_lanes.hpp"
#include "experiments/metric/tally.hpp"
#include "reference/exact_curve.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::judge {
namespace {

using Point = std::array<double, reference::max_dimension>;
using Lanes = reference::CertifiedLanes;
using LaneSet = std::uint32_t;  ///< a bit per lane

bool is_finite(std::span<const double> point) {
  return std::ranges::all_of(point, [](double value) { return std::isfinite(value); });
}

Point point_of(const PointsOfGroup& points, std::size_t lane) {
  return {points[0][lane], points[1][lane], points[2][lane]};
}

bool has(LaneSet set, std::size_t lane) { return (set >> lane & 1U) != 0; }

void add(const Lanes& errors, LaneSet lanes, metric::Tally& tally) {
  constexpr LaneSet all = (1ULL << trials_at_once) - 1;
  if (lanes == all) return tally.add(errors);
  for (std::size_t k = 0; k < errors.size(); ++k)
    if (has(lanes, k)) tally.add(std::span(errors).subspan(k, 1));
}

}  // namespace

/// What the errors of a group are measured from: the truth or a baseline.
template <class Scalar>
struct GroupJudge<Scalar>::Origin {
  bool is_truth = true;
  LaneSet exists = 0;      ///< lanes with such a point: the baseline is finite, the weights do not sum to zero
  LaneSet has_length = 0;  ///< lanes where |true point| is finite
  reference::CertifiedBlock points;
  Lanes length{};  ///< of the true point, and the spacing of numbers there
  Lanes ulp{};
  PointsOfGroup nearest{};  ///< the nearest numbers to the true coordinates
};

/// One trial of a group.
template <class Scalar>
struct GroupJudge<Scalar>::Lane {
  TrialNumber number;
  std::uint64_t counted;  ///< trial number, counted on through the replicates
  TrialInputs<Scalar> inputs;
  reference::TrialScale scale;
  reference::ExactCurve exact;
  std::optional<reference::TruePoint> truth;
};

/// Scratch of one thread.
template <class Scalar>
struct GroupJudge<Scalar>::Scratch {
  std::array<Lane, trials_at_once> group;
  GroupPoints<Scalar> points;
  SourceMeter<Scalar> sources;
  std::vector<PointsOfGroup> computed;                  ///< per method
  std::vector<std::uint64_t> own_kernel;                ///< per method: trials whose point its own kernel computed
  std::optional<reference::CertifiedPoints> certified;  ///< of the last cell; its binomials are kept
  reference::CertifiedBlock truths;
  metric::ScaleLanes scales;
  Lanes size{};  ///< of the curves; 0 without control points
  Lanes p_tilde{};
  Origin from;  ///< what errors are measured from at present
};

template <class Scalar>
void GroupJudge<Scalar>::judge(TrialNumber first, std::int64_t count, bool check, CellTally& block) const {
  judge_group(first, count, block, [&](Scratch& scratch) {
    for (std::size_t m = 0; m < methods_.count(); ++m) {
      if (!methods_.supported(methods_[m])) continue;
      scratch.points.evaluate(methods_[m], scratch.computed[m]);
      if (check) scratch.points.check_first(methods_[m], scratch.computed[m]);
      scratch.own_kernel[m] = methods_[m].is_judged_alone() ? static_cast<std::uint64_t>(count) : check ? 1 : 0;
    }
  });
}

template <class Scalar>
void GroupJudge<Scalar>::judge(TrialNumber first, std::span<const double> given, CellTally& block) const {
  const auto dimension = static_cast<std::size_t>(cell_.dimension);
  const std::size_t count = given.size() / dimension;
  judge_group(first, static_cast<std::int64_t>(count), block, [&](Scratch& scratch) {
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t axis = 0; axis < dimension; ++axis)
        scratch.computed.front()[axis][k] = given[k * dimension + axis];
    scratch.own_kernel.front() = count;
  });
}

template <class Scalar>
template <class Evaluate>
void GroupJudge<Scalar>::judge_group(TrialNumber first, std::int64_t count, CellTally& block,
                                     const Evaluate& evaluate) const {
  thread_local Scratch scratch;
  const std::span group(scratch.group.data(), static_cast<std::size_t>(count));
  draw(group, first, scratch);
  find_scales(group, scratch);
  find_truth(group, scratch);
  scratch.computed.assign(methods_.count(), {});
  scratch.own_kernel.assign(methods_.count(), 0);
  evaluate(scratch);
  for (std::size_t k = 0; k < methods_.baseline_count(); ++k) {
    if (methods_.is_exact(k)) {
      measure_from_truth(group, scratch);
      add_truth(group, scratch, block);
    } else if (methods_.supported(*methods_.baseline(k))) {
      measure_from(*methods_.baseline(k), group, scratch);
    }
    for (std::size_t m = 0; m < methods_.count(); ++m)
      if (methods_.judged(m, k)) judge_method(m, group, scratch, block.judgements[methods_.index(m, k)]);
  }
  if (tier_ == reference::Tier::certified)
    for (const auto& lane : group) block.escalated += lane.truth->needed_integers() ? 1 : 0;
}

template <class Scalar>
void GroupJudge<Scalar>::draw(Group group, TrialNumber first, Scratch& scratch) const {
  scratch.points.begin(cell_.dimension, cell_.degree);
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& lane = group[k];
    lane.number = {first.replicate, first.trial + static_cast<std::int64_t>(k)};
    lane.counted = static_cast<std::uint64_t>(lane.number.replicate * study_.trials + lane.number.trial);
    lane.inputs.be_of(study_.form, cell_);
    lane.inputs.draw(sampler_, lane.counted);
    scratch.size[k] = metric::size_of(lane.inputs.true_curve());
    scratch.points.add(lane.inputs.curve(), lane.inputs.t());
  }
}

template <class Scalar>
void GroupJudge<Scalar>::find_scales(Group group, Scratch& scratch) const {
  if (study_.form == Form::rational) {
    for (auto& lane : group) lane.scale.set(lane.inputs.true_curve(), lane.inputs.true_t());
  } else {
    scratch.scales.begin(cell_.dimension, cell_.degree);
    for (std::size_t k = 0; k < group.size(); ++k)
      scratch.scales.load(k, group[k].inputs.true_curve(), group[k].inputs.true_t());
    scratch.scales.compute(methods_.amplifications());
    for (std::size_t k = 0; k < group.size(); ++k)
      group[k].scale.set(group[k].inputs.true_curve(), group[k].inputs.true_t(), scratch.scales.largest(k),
                         scratch.scales.amplified(k));
  }
  for (std::size_t k = 0; k < group.size(); ++k) scratch.p_tilde[k] = group[k].scale.p_tilde();
}

template <class Scalar>
void GroupJudge<Scalar>::find_truth(Group group, Scratch& scratch) const {
  const Form form = study_.form;
  auto& certified = scratch.certified;
  const bool applies = tier_ == reference::Tier::certified && reference::CertifiedPoints::applies(form);
  if (applies) {
    if (!certified || !certified->is_for(form, cell_.dimension, cell_.degree))
      certified.emplace(form, cell_.dimension, cell_.degree);
    for (std::size_t k = 0; k < group.size(); ++k)
      certified->load(k, group[k].inputs.true_curve(), group[k].inputs.true_t());
    certified->evaluate();
    scratch.truths = certified->points();
  } else {
    scratch.truths.error.fill(std::numeric_limits<double>::quiet_NaN());
  }
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& lane = group[k];
    lane.truth.emplace(lane.exact, lane.inputs.true_curve(), lane.inputs.true_t(),
                       applies ? certified->point(k) : std::nullopt);
  }
}

template <class Scalar>
void GroupJudge<Scalar>::measure_from_truth(Group group, Scratch& scratch) const {
  Origin& from = scratch.from;
  from = Origin();
  from.points = scratch.truths;
  from.length = from.points.distances({});
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& truth = *group[k].truth;
    if (!truth.exists()) continue;
    from.exists |= LaneSet{1} << k;
    if (std::isnan(from.length[k])) from.length[k] = truth.length();
    if (std::isfinite(from.length[k])) from.has_length |= LaneSet{1} << k;
    from.ulp[k] = truth.ulp(from.length[k], ScalarFacts<Scalar>::format);
    for (int axis = 0; axis < cell_.dimension; ++axis)
      from.nearest[static_cast<std::size_t>(axis)][k] = truth.nearest(axis, ScalarFacts<Scalar>::format);
  }
}

template <class Scalar>
void GroupJudge<Scalar>::measure_from(const GroupMethod<Scalar>& baseline, Group group, Scratch& scratch) const {
  Origin& from = scratch.from;
  from = Origin();
  from.is_truth = false;
  scratch.points.evaluate(baseline, from.points.high);
  for (std::size_t k = 0; k < group.size(); ++k)
    if (is_finite(point_of(from.points.high, k))) from.exists |= LaneSet{1} << k;
}

template <class Scalar>
double GroupJudge<Scalar>::distance(const Origin& from, Lane& lane, std::size_t number,
                                    std::span<const double> point) const {
  if (from.is_truth) return lane.truth->distance(point);
  const Point baseline = point_of(from.points.high, number);
  return reference::Distance(std::span(baseline).first(point.size())).to(point);
}

template <class Scalar>
void GroupJudge<Scalar>::judge_method(std::size_t method, Group group, Scratch& scratch, Judgement& judgement) const {
  judgement.own_kernel += scratch.own_kernel[method];
  const PointsOfGroup& computed = scratch.computed[method];
  const Origin& from = scratch.from;
  Lanes errors = from.points.distances(computed);
  LaneSet measured = 0;
  for (std::size_t k = 0; k < group.size(); ++k) {
    const Point coordinates = point_of(computed, k);
    const auto point = std::span(coordinates).first(static_cast<std::size_t>(cell_.dimension));
    if (has(from.exists, k) && is_finite(point)) {
      if (std::isnan(errors[k])) errors[k] = distance(from, group[k], k, point);
      if (std::isfinite(errors[k])) measured |= LaneSet{1} << k;
      if (from.is_truth) take_apart(method, group[k], point, scratch.sources, judgement);
    }
    if (!has(measured, k)) ++judgement.non_finite;
  }
  add(errors, measured, judgement.error);
  const Lanes errors_u = metric::in_units(errors, scratch.p_tilde, ScalarFacts<Scalar>::arithmetic.unit_roundoff);
  add(errors_u, measured, judgement.error_u);
  if (!from.is_truth) return;
  add(metric::in_units(errors, from.ulp), measured, judgement.error_ulp);
  add(metric::in_units(errors, from.length), measured & from.has_length, judgement.relative);
  LaneSet sized = 0;
  for (std::size_t k = 0; k < group.size(); ++k)
    if (has(measured, k) && scratch.size[k] > 0 && std::isfinite(scratch.size[k])) sized |= LaneSet{1} << k;
  add(metric::in_units(errors, scratch.size), sized, judgement.error_size);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(cell_.dimension); ++axis)
    for (std::size_t k = 0; k < group.size(); ++k) {
      if (!has(measured, k)) continue;
      ++judgement.coordinates;
      judgement.misrounded += computed[axis][k] != from.nearest[axis][k] ? 1 : 0;
    }
  for (std::size_t k = 0; k < group.size(); ++k) {
    if (has(measured, k))
      metric::merge_fields(judgement.worst, std::optional(Worst{errors_u[k], errors[k], group[k].counted}));
    const double error = has(measured, k) ? errors[k] : std::numeric_limits<double>::infinity();
    if (has(from.exists, k)) compare_with_bound(method, error, group[k], from.length[k], judgement);
  }
}

template <class Scalar>
void GroupJudge<Scalar>::take_apart(std::size_t method, Lane& lane, std::span<const double> point,
                                    SourceMeter<Scalar>& sources, Judgement& judgement) const {
  if (lane.number.replicate != 0 || lane.number.trial >= study_.decomposed_trials) return;
  const auto apart =
      sources.measure(*methods_[method].kernel, lane.inputs.curve(), lane.inputs.t(), point, lane.truth->exact());
  if (apart) judgement.sources.add(*apart);
}

/// Adds what depends on the trials only and not on the methods.
template <class Scalar>
void GroupJudge<Scalar>::add_truth(Group group, Scratch& scratch, CellTally& block) const {
  const Origin& from = scratch.from;
  add(metric::in_units(scratch.p_tilde, from.length), from.exists, block.condition);
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& lane = group[k];
    if (has(from.exists, k) && lane.number.replicate == 0 && lane.number.trial < audited_trials_ &&
        sizeof(Scalar) == sizeof(double))
      block.audit.add(metric::to_24_bits(reference::audit_ulp(
          reference::long_double_point(lane.inputs.true_curve(), lane.inputs.true_t()), lane.truth->exact())));
  }
}

template <class Scalar>
void GroupJudge<Scalar>::compare_with_bound(std::size_t method, double error, Lane& lane, double length,
                                            Judgement& judgement) const {
  if (!methods_.bound(method)) return;
  const auto checked = lane.scale.check(error, *methods_.bound(method), ScalarFacts<Scalar>::arithmetic, length);
  if (!checked) return;
  ++judgement.bounded;
  judgement.bound.add(checked->bound);
  if (std::isfinite(checked->bound_u)) judgement.bound_u.add(checked->bound_u);
  if (checked->violated) judgement.violations.add(lane.counted);
}

template class GroupJudge<float>;
template class GroupJudge<double>;

}  // namespace bezierbench::judge
