// SPDX-License-Identifier: MIT
#include "experiments/studies/accuracy_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "experiments/failure.hpp"
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

static_assert(trials_at_once <= reference::CertifiedPoints::lanes);
constexpr std::int64_t block_trials = 1024;
constexpr std::int64_t audited_trials = 200;  ///< of replicate 0 of each cell
constexpr std::string_view exact_baseline = "exact";

/// Infinite where it overflows.
void add(double value, metric::Tally& tally) {
  const double rounded = metric::to_24_bits(value);
  if (std::isfinite(rounded))
    tally.add(rounded);
  else
    tally.add_infinite();
}

/// 0 / 0 is 0: no error, or nothing that an error could be measured with.
void add_quotient(double value, double divisor, metric::Tally& tally) { add(value == 0 ? 0 : value / divisor, tally); }

using Point = std::array<double, reference::max_dimension>;

bool is_finite(std::span<const double> point) {
  return std::ranges::all_of(point, [](double value) { return std::isfinite(value); });
}

/// What the errors of one trial are measured from: the truth or a baseline, or nothing where the baseline is not finite
/// or the weights of a rational curve sum to zero. `point` is the baseline's, which it refers to.
struct Origin {
  reference::TruePoint* truth = nullptr;
  double length = 0;  ///< of the true point, and the spacing of numbers there
  double ulp = 0;
  Point point{};
  std::optional<reference::Distance> baseline;

  [[nodiscard]] bool exists() const { return truth != nullptr || baseline; }
  [[nodiscard]] double distance(std::span<const double> computed) const {
    return truth != nullptr ? truth->distance(computed) : baseline->to(computed);
  }
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
  Origin from;  ///< what is measured from now
};

/// Scratch of one thread.
template <class Scalar>
struct Scratch {
  std::array<Lane<Scalar>, trials_at_once> group;
  GroupPoints<Scalar> points;
  SourceMeter<Scalar> sources;
  std::vector<PointsOfGroup> computed;  ///< per method
  PointsOfGroup baseline{};
};

template <class Scalar>
class ScalarCell final : public AccuracyCell {
 public:
  ScalarCell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell, reference::Tier tier)
      : study_(study), cell_(cell), tier_(tier), sampler_(seed, study.id, cell) {
    for (const auto* method : chosen_kernels<Scalar>(study, cell.dimension)) {
      methods_.emplace_back(*method);
      bounds_.emplace_back();
      if (method->info->bound) bounds_.back().emplace(*method->info->bound, cell.degree, arithmetic);
    }
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
  void draw(std::span<Lane<Scalar>> group, TrialNumber first, GroupPoints<Scalar>& points) const;
  void find_truth(std::span<Lane<Scalar>> group) const;
  void measure_from(std::size_t baseline, std::span<Lane<Scalar>> group, Scratch<Scalar>& scratch) const;
  void judge(std::size_t method, Lane<Scalar>& lane, const Point& computed, SourceMeter<Scalar>& sources,
             Judgement& judgement) const;
  void add_truth(Lane<Scalar>& lane, CellTally& block) const;
  void count(const std::optional<metric::BoundAtDegree>& proved, double error, Lane<Scalar>& lane,
             Judgement& judgement) const;
  void write_worst(std::size_t method, const Worst& worst, Tables& tables) const;

  const suite::Study& study_;
  sample::Cell cell_;
  reference::Tier tier_;
  sample::Sampler sampler_;
  std::vector<GroupMethod<Scalar>> methods_;
  std::vector<std::optional<metric::BoundAtDegree>> bounds_;   ///< per method
  std::vector<std::optional<GroupMethod<Scalar>>> baselines_;  ///< nothing for the exact reference
};

Point point_of(const PointsOfGroup& points, std::size_t trial) {
  return {points[0][trial], points[1][trial], points[2][trial]};
}

template <class Scalar>
void ScalarCell<Scalar>::judge_group(TrialNumber first, std::int64_t count, CellTally& block) const {
  thread_local Scratch<Scalar> scratch;
  const std::span group(scratch.group.data(), static_cast<std::size_t>(count));
  draw(group, first, scratch.points);
  find_truth(group);
  scratch.computed.resize(methods_.size());
  for (std::size_t m = 0; m < methods_.size(); ++m)
    if (supported(methods_[m])) scratch.points.evaluate(methods_[m], scratch.computed[m]);
  for (std::size_t k = 0; k < baselines_.size(); ++k) {
    measure_from(k, group, scratch);
    if (is_exact(k))
      for (auto& lane : group)
        if (lane.from.exists()) add_truth(lane, block);
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      if (!this->judged(m, k)) continue;
      Judgement& judgement = block.judgements[index(m, k)];
      for (std::size_t trial = 0; trial < group.size(); ++trial)
        judge(m, group[trial], point_of(scratch.computed[m], trial), scratch.sources, judgement);
    }
  }
  if (tier_ == reference::Tier::certified)
    for (const auto& lane : group) block.escalated += lane.truth->needed_integers() ? 1 : 0;
}

template <class Scalar>
void ScalarCell<Scalar>::draw(std::span<Lane<Scalar>> group, TrialNumber first, GroupPoints<Scalar>& points) const {
  points.begin(cell_.dimension, cell_.degree);
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& lane = group[k];
    lane.number = {first.replicate, first.trial + static_cast<std::int64_t>(k)};
    lane.counted = static_cast<std::uint64_t>(lane.number.replicate * study_.trials + lane.number.trial);
    lane.inputs.be_of(form_of(study_.curve), cell_);
    lane.inputs.draw(sampler_, lane.counted);
    lane.scale.set(lane.inputs.true_curve(), lane.inputs.true_t());
    points.add(lane.inputs.curve(), lane.inputs.t());
  }
}

template <class Scalar>
void ScalarCell<Scalar>::find_truth(std::span<Lane<Scalar>> group) const {
  const Form form = form_of(study_.curve);
  std::optional<reference::CertifiedPoints> certified;
  if (tier_ == reference::Tier::certified && reference::CertifiedPoints::applies(form, cell_.degree)) {
    certified.emplace(form, cell_.dimension, cell_.degree);
    for (std::size_t k = 0; k < group.size(); ++k)
      certified->load(k, group[k].inputs.true_curve(), group[k].inputs.true_t());
    certified->evaluate();
  }
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& lane = group[k];
    lane.truth.emplace(lane.exact, lane.inputs.true_curve(), lane.inputs.true_t(),
                       certified ? certified->point(k) : std::nullopt);
  }
}

template <class Scalar>
void ScalarCell<Scalar>::measure_from(std::size_t baseline, std::span<Lane<Scalar>> group,
                                      Scratch<Scalar>& scratch) const {
  const auto& method = baselines_[baseline];
  const bool by_method = method && supported(*method);
  if (by_method) scratch.points.evaluate(*method, scratch.baseline);
  for (std::size_t k = 0; k < group.size(); ++k) {
    auto& lane = group[k];
    Origin& from = lane.from;
    from.truth = nullptr;
    from.baseline.reset();
    if (is_exact(baseline) && lane.truth->exists()) {
      from.truth = &*lane.truth;
      from.length = lane.truth->length();
      from.ulp = lane.truth->ulp(from.length, ScalarFacts<Scalar>::format);
    } else if (by_method) {
      from.point = point_of(scratch.baseline, k);
      const auto point = std::span<const double>(from.point).first(static_cast<std::size_t>(cell_.dimension));
      if (is_finite(point)) from.baseline.emplace(point);
    }
  }
}

template <class Scalar>
void ScalarCell<Scalar>::judge(std::size_t method, Lane<Scalar>& lane, const Point& computed,
                               SourceMeter<Scalar>& sources, Judgement& judgement) const {
  const auto point = std::span<const double>(computed).first(static_cast<std::size_t>(cell_.dimension));
  if (!is_finite(point) || !lane.from.exists()) {
    ++judgement.non_finite;
    return;
  }
  count(bounds_[method], lane.from.distance(point), lane, judgement);
  if (lane.from.truth == nullptr || lane.number.replicate != 0 || lane.number.trial >= study_.decomposed_trials) return;
  const auto apart =
      sources.measure(*methods_[method].kernel, lane.inputs.curve(), lane.inputs.t(), point, lane.from.truth->exact());
  if (apart) judgement.sources.add(*apart);
}

/// What is known of the trial itself, whatever the methods.
template <class Scalar>
void ScalarCell<Scalar>::add_truth(Lane<Scalar>& lane, CellTally& block) const {
  add_quotient(lane.scale.p_tilde(), lane.from.length, block.condition);
  if (lane.number.replicate == 0 && lane.number.trial < audited_trials && sizeof(Scalar) == sizeof(double))
    block.audit.add(metric::to_24_bits(reference::audit_ulp(
        reference::long_double_point(lane.inputs.true_curve(), lane.inputs.true_t()), lane.from.truth->exact())));
}

template <class Scalar>
void ScalarCell<Scalar>::count(const std::optional<metric::BoundAtDegree>& proved, double error, Lane<Scalar>& lane,
                               Judgement& judgement) const {
  if (!std::isfinite(error)) {
    ++judgement.non_finite;
    return;
  }
  const Origin& from = lane.from;
  judgement.error.add(error);
  const double error_u = metric::to_24_bits(lane.scale.in_bound_units(error, arithmetic));
  add(error_u, judgement.error_u);
  if (from.truth == nullptr) return;
  add(error / from.ulp, judgement.error_ulp);
  if (std::isfinite(from.length)) add_quotient(error, from.length, judgement.relative);
  judgement.keep_worst({error_u, error, lane.counted});
  if (!proved) return;
  const double bound = lane.scale.bound(*proved, arithmetic, from.length);
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
