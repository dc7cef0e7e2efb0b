// SPDX-License-Identifier: MIT
#include "experiments/studies/accuracy_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "core/basis/amplification.hpp"
#include "experiments/failure.hpp"
#include "experiments/metric/error_lanes.hpp"
#include "experiments/metric/trial_scale.hpp"
#include "experiments/number/number.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/accuracy_row.hpp"
#include "experiments/studies/cell_fields.hpp"
#include "experiments/studies/error_sources.hpp"
#include "experiments/studies/group_points.hpp"
#include "experiments/studies/input_fields.hpp"
#include "experiments/studies/interruption.hpp"
#include "experiments/studies/method_choice.hpp"
#include "experiments/studies/methods.hpp"
#include "experiments/studies/scalar_facts.hpp"
#include "experiments/studies/trial_inputs.hpp"
#include "experiments/suite/names.hpp"
#include "reference/exact_curve.hpp"
#include "reference/long_double.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::int64_t block_trials = 1024;
constexpr std::int64_t audited_trials = 200;  ///< of replicate 0 of each cell
constexpr std::string_view exact_baseline = "exact";

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

/// What the errors of a group are measured from: the truth or a baseline.
struct Origin {
  bool is_truth = true;
  LaneSet exists = 0;      ///< without those where a baseline is not finite, or the weights sum to zero
  LaneSet has_length = 0;  ///< with a finite one
  reference::CertifiedBlock points;
  Lanes length{};  ///< of the true point, and the spacing of numbers there
  Lanes ulp{};
};

/// Which trial of which replicate.
struct TrialNumber {
  std::int64_t replicate;
  std::int64_t trial;
};

/// One trial of a group.
template <class Scalar>
struct Lane {
  TrialNumber number;
  std::uint64_t counted;  ///< its number through all replicates
  TrialInputs<Scalar> inputs;
  metric::TrialScale scale;
  reference::ExactCurve exact;
  std::optional<reference::TruePoint> truth;
};

/// Scratch of one thread.
template <class Scalar>
struct Scratch {
  std::array<Lane<Scalar>, trials_at_once> group;
  GroupPoints<Scalar> points;
  SourceMeter<Scalar> sources;
  std::vector<PointsOfGroup> computed;  ///< per method
  reference::CertifiedBlock truths;
  metric::ScaleLanes scales;
  std::vector<metric::KnownAmplification> amplified;
  Lanes p_tilde{};
  Origin from;  ///< what is measured from now
};

template <class Scalar>
class ScalarCell final : public AccuracyCell {
 public:
  ScalarCell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell, reference::Tier tier)
      : study_(study), cell_(cell), tier_(tier), sampler_(seed, study.id, cell) {
    for (const auto* method : chosen_kernels<Scalar>(study, cell.dimension)) {
      methods_.emplace_back(*method);
      bounds_.emplace_back();
      if (!method->info->bound) continue;
      bounds_.back().emplace(*method->info->bound, cell.degree, arithmetic);
      amplifications_.insert(method->info->bound->amplification);
    }
    amplifications_.insert(p_tilde_of(form_of(study.curve)));
    for (const auto& id : study.baseline) {
      const Kernel<Scalar>* kernel = nullptr;
      if (id != exact_baseline) {
        kernel = find_method<Scalar>(id, form_of(study.curve), cell.dimension);
        if (kernel == nullptr)
          throw Failure(Exit::usage,
                        fmt::format("study \"{}\": baseline \"{}\" does not take curves in {} form; see `list methods`",
                                    study.id, id, name(form_of(study.curve))));
      }
      baselines_.emplace_back();
      if (kernel != nullptr) baselines_.back().emplace(*kernel);
    }
  }

  [[nodiscard]] std::int64_t blocks_per_replicate() const { return (study_.trials - 1) / block_trials + 1; }
  [[nodiscard]] std::size_t blocks() const override {
    return static_cast<std::size_t>(blocks_per_replicate() * study_.replicates);
  }
  [[nodiscard]] double cost() const override {
    const double n = cell_.degree + 1.0;
    return static_cast<double>(std::min(study_.trials, block_trials)) *
           (200 + n * 150 + n * n * 2 * static_cast<double>(methods_.size()));
  }
  [[nodiscard]] Extent extent() const override {
    const auto trials = static_cast<std::uint64_t>(study_.trials * study_.replicates);
    const auto replicates = static_cast<std::size_t>(study_.replicates);
    constexpr std::size_t tallies = 200'000;  // two histograms of some fifty binades
    return {1, judgement_count(), trials * methods_.size(),
            judgement_count() * (tallies + 2 * replicates * sizeof(double))};
  }

  [[nodiscard]] CellTally run_block(std::size_t block) const override {
    const auto replicate = static_cast<std::int64_t>(block) / blocks_per_replicate();
    const auto part = static_cast<std::int64_t>(block) % blocks_per_replicate();
    const auto first = part * block_trials;
    const auto last = std::min(study_.trials, first + block_trials);
    CellTally work;
    work.blocks_per_replicate = blocks_per_replicate();
    work.judgements.resize(judgement_count());
    constexpr auto together = static_cast<std::int64_t>(trials_at_once);
    for (auto trial = first; trial < last && !interrupted(); trial += together)
      judge_group({replicate, trial}, std::min(together, last - trial), work);
    work.end_block(replicate);
    return work;
  }

  void write(const CellTally& tally, Tables& tables) const override;
  void collect(const CellTally& tally, std::vector<Series>& series) const override;
  void collect(const CellTally& tally, std::vector<Violation>& violations) const override;

 private:
  static constexpr auto arithmetic = ScalarFacts<Scalar>::arithmetic;

  /// Judgements are method by method, baseline by baseline.
  [[nodiscard]] std::size_t judgement_count() const { return methods_.size() * baselines_.size(); }
  [[nodiscard]] std::size_t index(std::size_t method, std::size_t baseline) const {
    return method * baselines_.size() + baseline;
  }
  [[nodiscard]] const MethodInfo& info(std::size_t method) const { return *methods_[method].kernel->info; }
  [[nodiscard]] bool supported(const GroupMethod<Scalar>& method) const {
    return method.kernel->info->template supports<Scalar>(cell_.degree);
  }
  [[nodiscard]] bool is_exact(std::size_t baseline) const { return !baselines_[baseline]; }
  [[nodiscard]] bool is_baseline(std::size_t method, std::size_t baseline) const {
    return baselines_[baseline] && baselines_[baseline]->kernel == methods_[method].kernel;
  }
  /// A method is not measured against itself.
  [[nodiscard]] bool judged(std::size_t method, std::size_t baseline) const {
    return !is_baseline(method, baseline) && supported(methods_[method]) &&
           (is_exact(baseline) || supported(*baselines_[baseline]));
  }
  [[nodiscard]] bool is_stable(std::size_t method, std::size_t baseline) const {
    return info(method).bit_stable && (is_exact(baseline) || baselines_[baseline]->kernel->info->bit_stable);
  }

  void judge_group(TrialNumber first, std::int64_t count, CellTally& block) const;
  void draw(std::span<Lane<Scalar>> group, TrialNumber first, Scratch<Scalar>& scratch) const;
  void find_scales(std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch) const;
  void find_truth(std::span<Lane<Scalar>> group, reference::CertifiedBlock& truths) const;
  void measure_from_truth(std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch) const;
  void measure_from(const GroupMethod<Scalar>& baseline, std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch) const;
  void judge(std::size_t method, std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch, Judgement& judgement) const;
  [[nodiscard]] double distance(const Origin& from, Lane<Scalar>& lane, std::size_t number,
                                std::span<const double> point) const;
  void take_apart(std::size_t method, Lane<Scalar>& lane, std::span<const double> point, SourceMeter<Scalar>& sources,
                  Judgement& judgement) const;
  void add_truth(std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch, CellTally& block) const;
  void compare_with_bound(std::size_t method, double error, Lane<Scalar>& lane, double length,
                          Judgement& judgement) const;
  void write_worst(std::size_t method, const Worst& worst, Tables& tables) const;

  const suite::Study& study_;
  sample::Cell cell_;
  reference::Tier tier_;
  sample::Sampler sampler_;
  std::vector<GroupMethod<Scalar>> methods_;
  std::vector<std::optional<metric::BoundAtDegree>> bounds_;   ///< per method
  std::set<Amplification> amplifications_;                     ///< of the bounds, and p~
  std::vector<std::optional<GroupMethod<Scalar>>> baselines_;  ///< nothing for the exact reference
};

template <class Scalar>
void ScalarCell<Scalar>::judge_group(TrialNumber first, std::int64_t count, CellTally& block) const {
  thread_local Scratch<Scalar> scratch;
  const std::span group(scratch.group.data(), static_cast<std::size_t>(count));
  draw(group, first, scratch);
  find_scales(group, scratch);
  find_truth(group, scratch.truths);
  scratch.computed.assign(methods_.size(), {});
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    if (!supported(methods_[m])) continue;
    scratch.points.evaluate(methods_[m], scratch.computed[m]);
    if (first.trial % block_trials == 0) scratch.points.check_first(methods_[m], scratch.computed[m]);
  }
  for (std::size_t k = 0; k < baselines_.size(); ++k) {
    if (is_exact(k)) {
      measure_from_truth(group, scratch);
      add_truth(group, scratch, block);
    } else if (supported(*baselines_[k])) {
      measure_from(*baselines_[k], group, scratch);
    }
    for (std::size_t m = 0; m < methods_.size(); ++m)
      if (this->judged(m, k)) judge(m, group, scratch, block.judgements[index(m, k)]);
  }
  if (tier_ == reference::Tier::certified)
    for (const auto& lane : group) block.escalated += lane.truth->needed_integers() ? 1 : 0;
}

template <class Scalar>
void ScalarCell<Scalar>::draw(std::span<Lane<Scalar>> group, TrialNumber first, Scratch<Scalar>& scratch) const {
  scratch.points.begin(cell_.dimension, cell_.degree);
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& lane = group[k];
    lane.number = {first.replicate, first.trial + static_cast<std::int64_t>(k)};
    lane.counted = static_cast<std::uint64_t>(lane.number.replicate * study_.trials + lane.number.trial);
    lane.inputs.be_of(form_of(study_.curve), cell_);
    lane.inputs.draw(sampler_, lane.counted);
    scratch.points.add(lane.inputs.curve(), lane.inputs.t());
  }
}

template <class Scalar>
void ScalarCell<Scalar>::find_scales(std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch) const {
  if (form_of(study_.curve) == Form::rational) {
    for (auto& lane : group) lane.scale.set(lane.inputs.true_curve(), lane.inputs.true_t());
  } else {
    scratch.scales.begin(cell_.dimension, cell_.degree);
    for (std::size_t k = 0; k < group.size(); ++k)
      scratch.scales.load(k, group[k].inputs.true_curve(), group[k].inputs.true_t());
    scratch.scales.take_norms();
    scratch.amplified.clear();
    for (const Amplification kind : amplifications_)
      scratch.amplified.push_back({kind, scratch.scales.amplifications(kind)});
    for (std::size_t k = 0; k < group.size(); ++k)
      group[k].scale.set(group[k].inputs.true_curve(), group[k].inputs.true_t(), scratch.scales, k, scratch.amplified);
  }
  for (std::size_t k = 0; k < group.size(); ++k) scratch.p_tilde[k] = group[k].scale.p_tilde();
}

template <class Scalar>
void ScalarCell<Scalar>::find_truth(std::span<Lane<Scalar>> group, reference::CertifiedBlock& truths) const {
  const Form form = form_of(study_.curve);
  std::optional<reference::CertifiedPoints> certified;
  if (tier_ == reference::Tier::certified && reference::CertifiedPoints::applies(form, cell_.degree)) {
    certified.emplace(form, cell_.dimension, cell_.degree);
    for (std::size_t k = 0; k < group.size(); ++k)
      certified->load(k, group[k].inputs.true_curve(), group[k].inputs.true_t());
    certified->evaluate();
    truths = certified->points();
  } else {
    truths.error.fill(std::numeric_limits<double>::quiet_NaN());
  }
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& lane = group[k];
    lane.truth.emplace(lane.exact, lane.inputs.true_curve(), lane.inputs.true_t(),
                       certified ? certified->point(k) : std::nullopt);
  }
}

template <class Scalar>
void ScalarCell<Scalar>::measure_from_truth(std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch) const {
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
  }
}

template <class Scalar>
void ScalarCell<Scalar>::measure_from(const GroupMethod<Scalar>& baseline, std::span<Lane<Scalar>> group,
                                      Scratch<Scalar>& scratch) const {
  Origin& from = scratch.from;
  from = Origin();
  from.is_truth = false;
  scratch.points.evaluate(baseline, from.points.high);
  for (std::size_t k = 0; k < group.size(); ++k)
    if (is_finite(point_of(from.points.high, k))) from.exists |= LaneSet{1} << k;
}

template <class Scalar>
double ScalarCell<Scalar>::distance(const Origin& from, Lane<Scalar>& lane, std::size_t number,
                                    std::span<const double> point) const {
  if (from.is_truth) return lane.truth->distance(point);
  const Point baseline = point_of(from.points.high, number);
  return reference::Distance(std::span(baseline).first(point.size())).to(point);
}

template <class Scalar>
void ScalarCell<Scalar>::judge(std::size_t method, std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch,
                               Judgement& judgement) const {
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
  const Lanes errors_u = metric::in_units(errors, scratch.p_tilde, arithmetic.unit_roundoff);
  add(errors_u, measured, judgement.error_u);
  if (!from.is_truth) return;
  add(metric::in_units(errors, from.ulp), measured, judgement.error_ulp);
  add(metric::in_units(errors, from.length), measured & from.has_length, judgement.relative);
  for (std::size_t k = 0; k < group.size(); ++k) {
    if (!has(measured, k)) continue;
    judgement.keep_worst({errors_u[k], errors[k], group[k].counted});
    compare_with_bound(method, errors[k], group[k], from.length[k], judgement);
  }
}

template <class Scalar>
void ScalarCell<Scalar>::take_apart(std::size_t method, Lane<Scalar>& lane, std::span<const double> point,
                                    SourceMeter<Scalar>& sources, Judgement& judgement) const {
  if (lane.number.replicate != 0 || lane.number.trial >= study_.decomposed_trials) return;
  const auto apart =
      sources.measure(*methods_[method].kernel, lane.inputs.curve(), lane.inputs.t(), point, lane.truth->exact());
  if (apart) judgement.sources.add(*apart);
}

/// What is known of the trials themselves, whatever the methods.
template <class Scalar>
void ScalarCell<Scalar>::add_truth(std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch, CellTally& block) const {
  const Origin& from = scratch.from;
  add(metric::in_units(scratch.p_tilde, from.length), from.exists, block.condition);
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& lane = group[k];
    if (has(from.exists, k) && lane.number.replicate == 0 && lane.number.trial < audited_trials &&
        sizeof(Scalar) == sizeof(double))
      block.audit.add(metric::to_24_bits(reference::audit_ulp(
          reference::long_double_point(lane.inputs.true_curve(), lane.inputs.true_t()), lane.truth->exact())));
  }
}

template <class Scalar>
void ScalarCell<Scalar>::compare_with_bound(std::size_t method, double error, Lane<Scalar>& lane, double length,
                                            Judgement& judgement) const {
  if (!bounds_[method]) return;
  const double bound = lane.scale.bound(*bounds_[method], arithmetic, length);
  if (!std::isfinite(bound)) return;  // nothing is proved here
  ++judgement.bounded;
  judgement.bound = std::max(judgement.bound, bound);
  const double bound_u = lane.scale.in_bound_units(bound, arithmetic);
  if (std::isfinite(bound_u)) judgement.bound_u = std::max(judgement.bound_u, bound_u);  // p~ = 0 has no such unit
  if (metric::TrialScale::violates(error, bound)) {
    ++judgement.violations;
    judgement.first_violation = std::min(judgement.first_violation, static_cast<std::int64_t>(lane.counted));
  }
}

const std::vector<std::string> tier_columns{"study", "curve", "scalar",    "dimension", "degree", "coordinate_range",
                                            "t_min", "t_max", "generator", "tier",      "trials", "escalated"};

const std::vector<std::string> audit_columns{
    "study", "curve", "tier",      "significand_bits", "dimension",      "degree",       "coordinate_range",
    "t_min", "t_max", "generator", "trials",           "mean_error_ulp", "max_error_ulp"};

std::vector<std::string> worst_columns() {
  std::vector<std::string> columns{"worst_id"};
  columns.insert(columns.end(), cell_columns().begin(), cell_columns().end());
  columns.insert(columns.end(), {"trial", "error", "error_u"});
  columns.insert(columns.end(), input_columns().begin(), input_columns().end());
  return columns;
}

template <class Scalar>
void ScalarCell<Scalar>::write(const CellTally& tally, Tables& tables) const {
  const auto number = [](double value) { return number::decimal(value); };
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    for (std::size_t k = 0; k < baselines_.size(); ++k) {
      if (is_baseline(m, k)) continue;
      auto row = cell_fields(study_, cell_, info(m).id, ScalarFacts<Scalar>::kind);
      row.push_back(std::to_string(study_.trials * study_.replicates));
      row.push_back(study_.baseline[k]);
      if (!judged(m, k)) {
        row.emplace_back(supported(methods_[m]) ? "baseline_degree_unsupported" : "degree_unsupported");
        row.resize(accuracy_columns().size());
      } else {
        const Judgement& judgement = tally.judgements[index(m, k)];
        row.emplace_back("ok");
        for (auto& field : accuracy_statistics(judgement, is_exact(k), tally.condition))
          row.push_back(std::move(field));
        if (judgement.worst && is_stable(m, k)) write_worst(m, *judgement.worst, tables);
      }
      tables.table(is_stable(m, k) ? "accuracy.csv" : "unstable.csv", accuracy_columns()).add_row(std::move(row));
    }
  }
  auto row = cell_fields(study_, cell_, "", ScalarFacts<Scalar>::kind);
  row.erase(row.begin() + 2);  // whatever the method
  row.insert(row.end(), {std::string(reference::name(tier_)), std::to_string(study_.trials * study_.replicates),
                         std::to_string(tally.escalated)});
  tables.table("reference.csv", tier_columns).add_row(std::move(row));
  if (tally.audit.count() > 0)
    tables.table("audit.csv", audit_columns)
        .add_row({study_.id, std::string(suite::name(study_.curve)), "long_double",
                  std::to_string(std::numeric_limits<long double>::digits), std::to_string(cell_.dimension),
                  std::to_string(cell_.degree), number(cell_.coordinate_range), number(cell_.t_interval.min),
                  number(cell_.t_interval.max), cell_.generator, std::to_string(tally.audit.count()),
                  number(tally.audit.mean()), number(tally.audit.max())});
}

template <class Scalar>
void ScalarCell<Scalar>::write_worst(std::size_t method, const Worst& worst, Tables& tables) const {
  auto& table = tables.table("worst.csv", worst_columns());
  TrialInputs<Scalar> inputs(form_of(study_.curve), cell_);
  inputs.draw(sampler_, worst.trial);
  std::vector<std::string> row{fmt::format("w{}", table.row_count() + 1)};
  for (auto& field : cell_fields(study_, cell_, info(method).id, ScalarFacts<Scalar>::kind))
    row.push_back(std::move(field));
  row.push_back(std::to_string(worst.trial));
  row.push_back(number::decimal(worst.error));
  row.push_back(number::decimal(worst.error_u));
  for (auto& field : input_fields(inputs.values(), cell_.dimension)) row.push_back(std::move(field));
  table.add_row(std::move(row));
}

/// One statistic of a judgement over the replicates that have it.
std::vector<double> over_replicates(const CellTally& tally, std::size_t judgement, double ReplicateStatistic::*which) {
  std::vector<double> values;
  for (const auto& [replicate, statistics] : tally.closed)
    if (const double value = statistics.at(judgement).*which; !std::isnan(value)) values.push_back(value);
  return values;
}

template <class Scalar>
void ScalarCell<Scalar>::collect(const CellTally& tally, std::vector<Series>& series) const {
  for (std::size_t m = 0; m < methods_.size(); ++m)
    for (std::size_t k = 0; k < baselines_.size(); ++k) {
      if (!judged(m, k)) continue;
      Series one{.study = study_.id,
                 .curve = std::string(suite::name(study_.curve)),
                 .method = std::string(info(m).id),
                 .statistic = "mean_error",
                 .degree = std::to_string(cell_.degree),
                 .coordinate_range = cell_.coordinate_range,
                 .t_interval = cell_.t_interval,
                 .generator = cell_.generator,
                 .baseline = study_.baseline[k],
                 .mode = "",
                 .values = over_replicates(tally, index(m, k), &ReplicateStatistic::mean)};
      series.push_back(one);
      one.statistic = "max_error";
      one.values = over_replicates(tally, index(m, k), &ReplicateStatistic::max);
      series.push_back(std::move(one));
    }
}

template <class Scalar>
void ScalarCell<Scalar>::collect(const CellTally& tally, std::vector<Violation>& violations) const {
  for (std::size_t m = 0; m < methods_.size(); ++m)
    for (std::size_t k = 0; k < baselines_.size(); ++k) {
      const Judgement& j = tally.judgements[index(m, k)];
      if (j.violations == 0) continue;
      violations.push_back(
          {fmt::format("{}, method {}, first at trial {}", describe(study_, cell_, ScalarFacts<Scalar>::kind),
                       info(m).id, j.first_violation),
           j.violations});
    }
}

}  // namespace

std::unique_ptr<AccuracyCell> accuracy_cell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell,
                                            suite::ScalarKind scalar, reference::Tier tier) {
  if (scalar == suite::ScalarKind::float32) return std::make_unique<ScalarCell<float>>(study, seed, cell, tier);
  return std::make_unique<ScalarCell<double>>(study, seed, cell, tier);
}

}  // namespace bezierbench::studies
