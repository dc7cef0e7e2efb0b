// SPDX-License-Identifier: MIT
// Studies of kind `exhaustive`: the curves of sets at every float of an interval.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/batch/batch.hpp"
#include "core/evaluate/kernel/prepared_state.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/exhaustive/float_tally.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/exact_curve.hpp"
#include "reference/float_values.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::uint64_t block_points = 1U << 17U;
constexpr std::size_t points_at_once = reference::float_values_at_once;
using Kernels = std::vector<const Kernel<float>*>;

/// Of each method of a part, in the order of the part.
struct Tallies {
  std::vector<FloatTally> of;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.of);
  }
  void merge(const Tallies& other) {
    if (of.empty()) of.resize(other.of.size());
    if (of.size() != other.of.size()) throw std::invalid_argument("tallies of different parts");
    for (std::size_t k = 0; k < of.size(); ++k) of[k].merge(other.of[k]);
  }
};

/// A method with a prepared curve: at many t the batch kernel of this processor where there is one, which gives the bits
/// of the method's own kernel, else that one.
class PreparedMethod {
 public:
  PreparedMethod(const Kernel<float>& kernel, const CurveView<float>& curve) : prepared_(kernel, curve) {
    for (const auto* target : batch::usable_targets())
      if (!batch_) batch_ = batch::find(*target, kernel);
  }

  /// The point at one t, by the method's own kernel.
  [[nodiscard]] std::array<float, reference::max_dimension> point(float t) const {
    std::array<float, reference::max_dimension> point{};
    prepared_.evaluate(std::span<const float>(&t, 1), point.data());
    return point;
  }

  /// Coordinate `axis` of the point at t[k] goes to values[axis * t.size() + k].
  void points(std::span<const float> t, std::span<float> values) {
    if (batch_) return batch_(prepared_.get(), t, values.data());
    side_by_side_.resize(axes() * t.size());
    prepared_.evaluate(t, side_by_side_.data());
    for (std::size_t axis = 0; axis < axes(); ++axis)
      for (std::size_t k = 0; k < t.size(); ++k) values[axis * t.size() + k] = side_by_side_[k * axes() + axis];
  }

  /// Throws std::logic_error unless the first of these points has the bits of the method's own kernel.
  void check_first(std::span<const float> t, std::span<const float> values) const {
    const auto expected = point(t.front());
    for (std::size_t axis = 0; axis < axes(); ++axis)
      if (std::bit_cast<std::uint32_t>(values[axis * t.size()]) != std::bit_cast<std::uint32_t>(expected[axis]))
        throw std::logic_error(fmt::format("the batch kernel of {} differs from the method at t = {}",
                                           prepared_.kernel().info->id, t.front()));
  }

 private:
  [[nodiscard]] std::size_t axes() const { return static_cast<std::size_t>(prepared_.kernel().dimension); }

  PreparedState<float> prepared_;
  batch::BatchKernel<float> batch_;
  std::vector<float> side_by_side_;
};

/// A curve at the floats of an interval, with the methods that take it.
struct Part {
  const FloatCurve* curve;
  FloatRange range;
  Kernels kernels;

  [[nodiscard]] std::size_t axes() const { return static_cast<std::size_t>(curve->dimension); }
};

/// Judges the methods of a part at consecutive floats.
class BlockJudge {
 public:
  explicit BlockJudge(const Part& part) : part_(part) {
    for (int axis = 0; axis < part.curve->dimension; ++axis) {
      const auto coordinates = part.curve->axis(axis);
      limits_.emplace_back(coordinates);
      values_of_.emplace_back(coordinates);
    }
    truth_.resize(part.axes());
    for (const auto* kernel : part.kernels) methods_.emplace_back(*kernel, part.curve->view());
    before_.resize(part.kernels.size());
  }

  Tallies judge(const FloatRange& block) {
    Tallies tallies;
    tallies.of.resize(methods_.size());
    const bool has_before = block.first > part_.range.first;
    if (has_before)
      for (std::size_t m = 0; m < methods_.size(); ++m) before_[m] = methods_[m].point(float_of(block.first - 1));
    bool is_first = true;
    for (std::uint64_t from = block.first; from <= block.last && !run::interrupted(); from += points_at_once) {
      fill(static_cast<std::uint32_t>(from), block.last);
      for (std::size_t m = 0; m < methods_.size(); ++m) {
        methods_[m].points(t_, values_);
        if (is_first) methods_[m].check_first(t_, values_);
        add(m, has_before || !is_first, tallies.of[m]);
      }
      is_first = false;
    }
    return tallies;
  }

 private:
  /// The t from these bits on, and the truth at them.
  void fill(std::uint32_t from, std::uint32_t last) {
    t_.clear();
    for (std::uint64_t bits = from; bits <= last && t_.size() < points_at_once; ++bits)
      t_.push_back(float_of(static_cast<std::uint32_t>(bits)));
    values_.resize(part_.axes() * t_.size());
    for (std::size_t axis = 0; axis < part_.axes(); ++axis) values_of_[axis].find(t_, truth_[axis]);
  }

  void add(std::size_t method, bool has_before, FloatTally& tally) {
    judge_.begin(t_.size());
    auto& before = before_[method];
    for (std::size_t axis = 0; axis < part_.axes(); ++axis) {
      const float* values = values_.data() + axis * t_.size();
      judge_.add_axis(limits_[axis], truth_[axis], values, has_before ? &before[axis] : nullptr);
      before[axis] = values[t_.size() - 1];
    }
    judge_.end(std::bit_cast<std::uint32_t>(t_.front()), tally);
  }

  const Part& part_;
  std::vector<AxisLimits> limits_;
  std::vector<reference::FloatValuesOf> values_of_;
  std::vector<reference::FloatValues> truth_;
  std::vector<PreparedMethod> methods_;
  std::vector<std::array<float, reference::max_dimension>> before_;  ///< of each method, the point at the t before
  std::vector<float> t_;
  std::vector<float> values_;
  FloatJudge judge_;
};

/// The largest error of a coordinate at this t in ulp(p), rounded to 24 bits; empty where one is not finite.
std::optional<double> exact_error(const FloatCurve& curve, const Kernel<float>& kernel, float t) {
  const auto point = PreparedMethod(kernel, curve.view()).point(t);
  reference::ExactCurve exact;
  double largest = 0;
  for (int axis = 0; axis < curve.dimension; ++axis) {
    const double computed = point[static_cast<std::size_t>(axis)];
    if (!std::isfinite(computed)) return std::nullopt;
    const auto coordinates = curve.axis(axis);
    const std::vector<double> coefficients(coordinates.begin(), coordinates.end());
    const auto& truth = exact.point({Form::bernstein, 1, curve.degree(), coefficients}, t);
    const reference::Distance distance(truth);
    const double error = distance.to(std::span(&computed, 1));
    largest = std::max(largest, error / ulp_of_length(truth, distance.to_origin(1), reference::binary32));
  }
  return largest;
}

/// A curve and an interval are a part.
class ExhaustiveJob final : public run::JobOf<Tallies> {
 public:
  explicit ExhaustiveJob(const suite::Study& study) : study_(study) {
    for (const auto& set : study_.sets)
      for (std::size_t k = 0; k < set->curves.size(); ++k)
        if (set->curves[k].form == Form::bernstein) curves_.emplace_back(set->id, set->curves.id(k), set->curves[k]);
    if (curves_.empty())
      suite::refuse(study_, {"curves", 0, "kind", "the sets have no curve in Bernstein form without weights"});
    for (const FloatCurve& curve : curves_)
      for (std::size_t k = 0; k < study_.t_interval.size(); ++k) {
        const auto range = floats_in(study_.t_interval[k]);
        if (!range) suite::refuse(study_, {"t_interval", k, {}, "there is no float in this t_interval; widen it"});
        parts_.push_back({&curve, *range, kernels_for(curve)});
        blocks_ = std::max(blocks_, static_cast<std::size_t>((range->count() - 1) / block_points + 1));
      }
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return blocks_; }
  [[nodiscard]] double cost(std::size_t part) const override {
    const auto& [curve, range, kernels] = parts_[part];
    const double points = static_cast<double>(range.count()) / static_cast<double>(blocks_);
    const double n = curve->degree() + 1.0;
    return points * curve->dimension * (5 + static_cast<double>(kernels.size()) * (1 + 0.1 * n * n));
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (const auto& part : parts_) sum += {1, part.kernels.size(), part.range.count() * part.kernels.size()};
    return sum;
  }
  void write(tables::Tables& tables) const override;

 protected:
  [[nodiscard]] Tallies work(std::size_t block) const override {
    const auto& part = parts_[part_of(block)];
    const std::uint64_t number = block % blocks_;
    const auto begin = [&](std::uint64_t k) { return part.range.first + part.range.count() * k / blocks_; };
    if (begin(number) == begin(number + 1) || part.kernels.empty()) return {};
    return BlockJudge(part).judge(
        {static_cast<std::uint32_t>(begin(number)), static_cast<std::uint32_t>(begin(number + 1) - 1)});
  }

 private:
  [[nodiscard]] Kernels kernels_for(const FloatCurve& curve) const;

  suite::Study study_;
  std::vector<FloatCurve> curves_;
  std::vector<Part> parts_;
  std::size_t blocks_ = 1;
};

Kernels ExhaustiveJob::kernels_for(const FloatCurve& curve) const {
  Kernels kernels;
  sample::Cell cell;
  cell.dimension = curve.dimension;
  for (const auto* kernel : judge::chosen_kernels<float>(study_, cell))
    if (kernel->info->bit_stable && kernel->info->supports<float>(curve.degree())) kernels.push_back(kernel);
  return kernels;
}

void ExhaustiveJob::write(tables::Tables& tables) const {
  (void)tables.table("exhaustive.csv");
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const auto& [curve, range, kernels] = parts_[part];
    bool is_monotone = false;
    for (int axis = 0; axis < curve->dimension; ++axis) {
      const AxisLimits limits(curve->axis(axis));
      is_monotone = is_monotone || limits.rises || limits.falls;
    }
    for (std::size_t m = 0; m < kernels.size(); ++m) {
      const FloatTally& tally = state(part).of.at(m);
      const float worst = float_of(tally.worst_t);
      tables.add(tables::Row("exhaustive.csv")
                     .set("study", study_.id)
                     .set("curve_id", curve->id)
                     .set("curves", curve->set)
                     .set("method", kernels[m]->info->id)
                     .set("scalar", suite::name(suite::ScalarKind::float32))
                     .set("degree", curve->degree())
                     .set("t_min", double{float_of(range.first)})
                     .set("t_max", double{float_of(range.last)})
                     .set("points", range.count())
                     .set("max_error_ulp", exact_error(*curve, *kernels[m], worst))
                     .set("worst_t", tables::Hexadecimal{double{worst}})
                     .set("misrounded", tally.misrounded)
                     .set("non_monotone", is_monotone ? std::optional(tally.non_monotone) : std::nullopt)
                     .set("out_of_hull", tally.out_of_hull));
    }
  }
}

std::unique_ptr<run::Job> exhaustive_job(const suite::Study& study, const run::JobContext& /*context*/) {
  return std::make_unique<ExhaustiveJob>(study);
}

constexpr std::array<std::string_view, 9> keys_without{"dimension",  "coordinate_range", "generator",
                                                       "scalar",     "trials",           "replicates",
                                                       "parameters", "parameters_from",  "placement"};

}  // namespace

extern constexpr StudyKind exhaustive_kind{
    .asks = {.id = "exhaustive",
             .about = "every float of an interval: the largest error on the curves of sets, and where it is",
             .own = {},
             .methods_example = "[\"de_casteljau*\"]",
             .inputs = {.forms = suite::bernstein_form,
                        .forms_reason = "what it counts is about control points",
                        .degree = suite::DegreeUse::not_a_key,
                        .degree_reason = "degree is that of the curve",
                        .parameters = suite::Parameters::from_0_to_1,
                        .parameters_reason = "Bezier curves are those of t in [0, 1]",
                        .sets = suite::SetUse::required},
             .without = keys_without,
             .without_reason = "the curves are those of sets, methods compute in float, and every t is tried"},
    .make = exhaustive_job};

}  // namespace bezierbench::studies
