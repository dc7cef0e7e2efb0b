// SPDX-License-Identifier: MIT
#include "experiments/studies/accuracy_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

#include "experiments/failure.hpp"
#include "experiments/metric/trial_scale.hpp"
#include "experiments/number/number.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/interruption.hpp"
#include "experiments/studies/judgement.hpp"
#include "experiments/studies/method_choice.hpp"
#include "experiments/studies/workspace.hpp"
#include "experiments/suite/names.hpp"
#include "reference/exact_curve.hpp"
#include "reference/long_double.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::int64_t block_trials = 1024;
constexpr std::int64_t audited_trials = 1000;  ///< of replicate 0 of each cell
constexpr std::string_view exact_baseline = "exact";
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// One replicate whose blocks are not all done.
struct OpenReplicate {
  std::vector<metric::Tally> errors;  ///< per judgement
  std::int64_t blocks_left = 0;
};

template <class Scalar>
constexpr metric::Arithmetic arithmetic_of() {
  return sizeof(Scalar) == sizeof(float) ? metric::float_arithmetic : metric::double_arithmetic;
}

template <class Scalar>
class ScalarCell final : public AccuracyCell {
 public:
  ScalarCell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell)
      : study_(study), cell_(cell), sampler_(seed, study.id, cell) {
    methods_ = chosen_kernels<Scalar>(study, cell.dimension);
    for (const auto& id : study.baseline) {
      const Kernel<Scalar>* kernel = nullptr;
      if (id != exact_baseline) {
        kernel = find_kernel<Scalar>(id, form_of(study.curve), cell.dimension);
        if (kernel == nullptr)
          throw Failure(Exit::usage,
                        fmt::format("study \"{}\": baseline \"{}\" does not take curves in {} form; see `list methods`",
                                    study.id, id, name(form_of(study.curve))));
      }
      baselines_.push_back(kernel);
    }
    replicate_means_.resize(judgement_count());
    replicate_maxima_.resize(judgement_count());
    for (auto& values : replicate_means_) values.resize(static_cast<std::size_t>(study.replicates));
    for (auto& values : replicate_maxima_) values.resize(static_cast<std::size_t>(study.replicates));
    judgements_.resize(judgement_count());
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

  void run_block(std::size_t block) override {
    const auto replicate = static_cast<std::int64_t>(block) / blocks_per_replicate();
    const auto part = static_cast<std::int64_t>(block) % blocks_per_replicate();
    const auto first = part * block_trials;
    const auto last = std::min(study_.trials, first + block_trials);
    std::vector<Judgement> judged(judgement_count());
    metric::Tally audit;
    for (auto trial = first; trial < last && !interrupted(); ++trial) judge(replicate, trial, judged, audit);
    keep(replicate, judged, audit);
  }

  void write(Tables& tables) const override;
  void collect(std::vector<Series>& series) const override;
  void collect(std::vector<Violation>& violations) const override;

 private:
  /// Judgements are method by method, baseline by baseline.
  [[nodiscard]] std::size_t judgement_count() const { return methods_.size() * baselines_.size(); }
  [[nodiscard]] std::size_t index(std::size_t method, std::size_t baseline) const {
    return method * baselines_.size() + baseline;
  }
  [[nodiscard]] bool supported(const Kernel<Scalar>& kernel) const {
    return kernel.info->template supports<Scalar>(cell_.degree);
  }
  /// A method is not measured against itself.
  [[nodiscard]] bool judged(std::size_t method, std::size_t baseline) const {
    return baselines_[baseline] != methods_[method] && supported(*methods_[method]) &&
           (baselines_[baseline] == nullptr || supported(*baselines_[baseline]));
  }
  [[nodiscard]] std::string describe() const {
    return fmt::format("study {}, {} {} degree {}, range {}, t in [{}, {}], generator {}", study_.id,
                       suite::name(study_.curve), scalar_name(), cell_.degree, number::decimal(cell_.coordinate_range),
                       number::decimal(cell_.t_interval.min), number::decimal(cell_.t_interval.max), cell_.generator);
  }
  [[nodiscard]] static std::string_view scalar_name() {
    return suite::name(sizeof(Scalar) == sizeof(float) ? suite::ScalarKind::float32 : suite::ScalarKind::float64);
  }

  void judge(std::int64_t replicate, std::int64_t trial, std::vector<Judgement>& judgements,
             metric::Tally& audit) const;
  static void count(double error, std::uint64_t trial, const std::optional<ErrorBound>& stated,
                    metric::TrialScale& scale, Judgement& judgement);
  void keep(std::int64_t replicate, std::vector<Judgement>& judged, metric::Tally& audit);

  const suite::Study& study_;
  sample::Cell cell_;
  sample::Sampler sampler_;
  std::vector<const Kernel<Scalar>*> methods_;
  std::vector<const Kernel<Scalar>*> baselines_;

  std::mutex mutex_;  ///< guards all below
  std::vector<Judgement> judgements_;
  std::vector<std::vector<double>> replicate_means_;
  std::vector<std::vector<double>> replicate_maxima_;
  std::map<std::int64_t, OpenReplicate> open_;
  metric::Tally audit_;  ///< of the long double tier, in ulp
};

/// What a method returned, in double, which holds any float.
struct Computed {
  std::array<double, reference::max_dimension> point{};
  bool finite = true;
};

/// Scratch of one thread.
template <class Scalar>
struct Scratch {
  sample::Trial trial;
  std::vector<Scalar> coefficients;  ///< the trial's, in the scalar type of the methods
  PreparedStorage prepared;
  reference::ExactCurve exact;
  metric::TrialScale scale;
  std::vector<Computed> computed;  ///< per method
};

template <class Scalar>
Computed computed_point(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve, Scalar t,
                        PreparedStorage& storage) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  std::array<Scalar, reference::max_dimension> point{};
  evaluate_once(kernel, curve, t, storage, std::span<Scalar>(point.data(), d));
  Computed computed;
  for (std::size_t axis = 0; axis < d; ++axis) {
    computed.point[axis] = static_cast<double>(point[axis]);
    computed.finite = computed.finite && std::isfinite(point[axis]);
  }
  return computed;
}

template <class Scalar>
void ScalarCell<Scalar>::judge(std::int64_t replicate, std::int64_t trial, std::vector<Judgement>& judgements,
                               metric::Tally& audit) const {
  thread_local Scratch<Scalar> scratch;
  const auto number = static_cast<std::uint64_t>(replicate * study_.trials + trial);
  sampler_.draw(number, scratch.trial);
  const auto t = static_cast<Scalar>(scratch.trial.t);
  auto& drawn = scratch.trial.coefficients;
  scratch.coefficients.assign(drawn.begin(), drawn.end());
  std::copy(scratch.coefficients.begin(), scratch.coefficients.end(), drawn.begin());  // as the methods see them
  const Form form = form_of(study_.curve);
  const CurveView<Scalar> curve{form, cell_.dimension, cell_.degree, scratch.coefficients};
  const CurveView<double> true_curve{form, cell_.dimension, cell_.degree, drawn};
  const auto d = static_cast<std::size_t>(cell_.dimension);
  scratch.scale.set(true_curve, static_cast<double>(t));

  scratch.computed.resize(methods_.size());
  for (std::size_t m = 0; m < methods_.size(); ++m)
    if (supported(*methods_[m])) scratch.computed[m] = computed_point(*methods_[m], curve, t, scratch.prepared);
  for (std::size_t k = 0; k < baselines_.size(); ++k) {
    Computed origin;
    std::optional<reference::Distance> distance;  // stays empty where the baseline itself is not finite
    if (baselines_[k] == nullptr) {
      const auto& exact = scratch.exact.point(true_curve, static_cast<double>(t));
      distance.emplace(exact);
      if (replicate == 0 && trial < audited_trials && sizeof(Scalar) == sizeof(double))
        audit.add(metric::to_24_bits(
            reference::audit_ulp(reference::long_double_point(true_curve, static_cast<double>(t)), exact)));
    } else if (supported(*baselines_[k])) {
      origin = computed_point(*baselines_[k], curve, t, scratch.prepared);
      if (origin.finite) distance.emplace(std::span<const double>(origin.point.data(), d));
    }
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      if (!this->judged(m, k)) continue;
      const Computed& computed = scratch.computed[m];
      const double error = computed.finite && distance ? distance->to({computed.point.data(), d})
                                                       : std::numeric_limits<double>::infinity();
      const bool against_truth = baselines_[k] == nullptr;
      count(error, number, against_truth ? methods_[m]->info->bound : std::nullopt, scratch.scale,
            judgements[index(m, k)]);
    }
  }
}

template <class Scalar>
void ScalarCell<Scalar>::count(double error, std::uint64_t trial, const std::optional<ErrorBound>& stated,
                               metric::TrialScale& scale, Judgement& judgement) {
  if (!std::isfinite(error)) {
    ++judgement.non_finite;
    return;
  }
  judgement.error.add(error);
  const double error_u = metric::to_24_bits(scale.in_bound_units(error, arithmetic_of<Scalar>()));
  if (std::isfinite(error_u))
    judgement.error_u.add(error_u);
  else
    judgement.error_u.add_infinite();
  if (!stated) return;
  const double bound = scale.bound(*stated, arithmetic_of<Scalar>());
  if (!std::isfinite(bound)) return;  // nothing is proved here
  ++judgement.bounded;
  const double bound_u = scale.in_bound_units(bound, arithmetic_of<Scalar>());
  if (std::isfinite(bound_u)) judgement.bound_u = std::max(judgement.bound_u, bound_u);  // p~ = 0 has no such unit
  if (metric::TrialScale::violates(error, bound)) {
    ++judgement.violations;
    judgement.first_violation = std::min(judgement.first_violation, static_cast<std::int64_t>(trial));
  }
}

template <class Scalar>
void ScalarCell<Scalar>::keep(std::int64_t replicate, std::vector<Judgement>& judged, metric::Tally& audit) {
  const std::lock_guard lock(mutex_);
  auto [entry, fresh] = open_.try_emplace(replicate);
  OpenReplicate& open = entry->second;
  if (fresh) {
    open.errors.resize(judged.size());
    open.blocks_left = blocks_per_replicate();
  }
  for (std::size_t k = 0; k < judged.size(); ++k) {
    open.errors[k].merge(judged[k].error);
    judgements_[k].merge(judged[k]);
  }
  audit_.merge(audit);
  if (--open.blocks_left > 0) return;
  for (std::size_t k = 0; k < judged.size(); ++k) {
    const bool empty = open.errors[k].count() == 0;  // every trial was non-finite: this replicate has no statistic
    const auto index = static_cast<std::size_t>(replicate);
    replicate_means_[k][index] = empty ? not_a_number : open.errors[k].mean();
    replicate_maxima_[k][index] = empty ? not_a_number : open.errors[k].max();
  }
  open_.erase(entry);
}

const std::vector<std::string> accuracy_columns{"study",
                                                "curve",
                                                "method",
                                                "scalar",
                                                "dimension",
                                                "degree",
                                                "coordinate_range",
                                                "t_min",
                                                "t_max",
                                                "generator",
                                                "trials",
                                                "baseline",
                                                "status",
                                                "mean_error",
                                                "rms_error",
                                                "p50_error",
                                                "p99_error",
                                                "max_error",
                                                "mean_error_u",
                                                "max_error_u",
                                                "bound_u",
                                                "bound_violations",
                                                "non_finite"};

const std::vector<std::string> audit_columns{
    "study", "curve", "tier",      "significand_bits", "dimension",      "degree",       "coordinate_range",
    "t_min", "t_max", "generator", "trials",           "mean_error_ulp", "max_error_ulp"};

template <class Scalar>
void ScalarCell<Scalar>::write(Tables& tables) const {
  const auto number = [](double value) { return number::decimal(value); };
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    for (std::size_t k = 0; k < baselines_.size(); ++k) {
      if (baselines_[k] == methods_[m]) continue;
      const bool stable =
          methods_[m]->info->bit_stable && (baselines_[k] == nullptr || baselines_[k]->info->bit_stable);
      std::vector<std::string> row{study_.id,
                                   std::string(suite::name(study_.curve)),
                                   std::string(methods_[m]->info->id),
                                   std::string(scalar_name()),
                                   std::to_string(cell_.dimension),
                                   std::to_string(cell_.degree),
                                   number(cell_.coordinate_range),
                                   number(cell_.t_interval.min),
                                   number(cell_.t_interval.max),
                                   cell_.generator,
                                   std::to_string(study_.trials * study_.replicates),
                                   study_.baseline[k]};
      if (!judged(m, k)) {
        row.emplace_back(supported(*methods_[m]) ? "baseline_degree_unsupported" : "degree_unsupported");
        row.resize(accuracy_columns.size());
      } else {
        const Judgement& j = judgements_[index(m, k)];
        const bool bounded = j.bounded > 0;
        const auto statistic = [&](double value) { return j.error.count() > 0 ? number(value) : std::string(); };
        for (const auto& field :
             {std::string("ok"), statistic(j.error.mean()), statistic(j.error.root_mean_square()),
              statistic(j.error.quantile(0.5)), statistic(j.error.quantile(0.99)), statistic(j.error.max()),
              statistic(j.error_u.mean()), statistic(j.error_u.max()), bounded ? number(j.bound_u) : std::string(),
              bounded ? std::to_string(j.violations) : std::string(), std::to_string(j.non_finite)})
          row.push_back(field);
      }
      tables.table(stable ? "accuracy.csv" : "unstable.csv", accuracy_columns).add_row(std::move(row));
    }
  }
  if (audit_.count() > 0)
    tables.table("audit.csv", audit_columns)
        .add_row({study_.id, std::string(suite::name(study_.curve)), "long_double",
                  std::to_string(std::numeric_limits<long double>::digits), std::to_string(cell_.dimension),
                  std::to_string(cell_.degree), number(cell_.coordinate_range), number(cell_.t_interval.min),
                  number(cell_.t_interval.max), cell_.generator, std::to_string(audit_.count()), number(audit_.mean()),
                  number(audit_.max())});
}

/// The statistics of the replicates that have one.
std::vector<double> defined(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return values;
}

template <class Scalar>
void ScalarCell<Scalar>::collect(std::vector<Series>& series) const {
  for (std::size_t m = 0; m < methods_.size(); ++m)
    for (std::size_t k = 0; k < baselines_.size(); ++k) {
      if (!judged(m, k)) continue;
      Series one{.study = study_.id,
                 .curve = std::string(suite::name(study_.curve)),
                 .method = std::string(methods_[m]->info->id),
                 .statistic = "mean_error",
                 .degree = std::to_string(cell_.degree),
                 .coordinate_range = cell_.coordinate_range,
                 .t_interval = cell_.t_interval,
                 .generator = cell_.generator,
                 .baseline = study_.baseline[k],
                 .mode = "",
                 .values = defined(replicate_means_[index(m, k)])};
      series.push_back(one);
      one.statistic = "max_error";
      one.values = defined(replicate_maxima_[index(m, k)]);
      series.push_back(std::move(one));
    }
}

template <class Scalar>
void ScalarCell<Scalar>::collect(std::vector<Violation>& violations) const {
  for (std::size_t m = 0; m < methods_.size(); ++m)
    for (std::size_t k = 0; k < baselines_.size(); ++k) {
      const Judgement& j = judgements_[index(m, k)];
      if (j.violations == 0) continue;
      violations.push_back(
          {fmt::format("{}, method {}, first at trial {}", describe(), methods_[m]->info->id, j.first_violation),
           j.violations});
    }
}

}  // namespace

std::unique_ptr<AccuracyCell> accuracy_cell(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell,
                                            suite::ScalarKind scalar) {
  if (scalar == suite::ScalarKind::float32) return std::make_unique<ScalarCell<float>>(study, seed, cell);
  return std::make_unique<ScalarCell<double>>(study, seed, cell);
}

}  // namespace bezierbench::studies
