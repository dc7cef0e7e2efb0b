// SPDX-License-Identifier: MIT
// Studies of kind `easing_floats`: y at every float x of an interval on the easing curves of sets, by methods in float.
// Writes easing_floats.csv.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/easing/kernel.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/easing/easing_curves.hpp"
#include "experiments/studies/exhaustive/float_tally.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/companion/easing.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::uint64_t floats_of_block = 1U << 16U;
constexpr std::size_t floats_at_once = 1024;

/// What one method does at the floats of a part.
struct EasedFloats {
  std::uint64_t misrounded = 0;
  std::uint64_t non_monotone = 0;   ///< steps to the next float at which y falls
  std::uint64_t not_converged = 0;  ///< floats at which a loop was ended
  std::uint64_t max_steps = 0;
  double max_error = -1;        ///< in ulp, right to 2^-22; infinite where y is not finite
  std::uint32_t worst_x = ~0U;  ///< bits of the first x that has it

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.misrounded, self.non_monotone, self.not_converged, self.max_steps, self.max_error, self.worst_x);
  }
  void add_error(double error, std::uint32_t x) {
    if (error < max_error || (error == max_error && x > worst_x)) return;
    max_error = error;
    worst_x = x;
  }
  void merge(const EasedFloats& other) {
    misrounded += other.misrounded;
    non_monotone += other.non_monotone;
    not_converged += other.not_converged;
    max_steps = std::max(max_steps, other.max_steps);
    if (other.max_error >= 0) add_error(other.max_error, other.worst_x);
  }
};

struct EasedFloatsOfMethods {
  std::vector<EasedFloats> of;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.of);
  }
  void merge(const EasedFloatsOfMethods& other) {
    if (of.empty()) of.resize(other.of.size());
    for (std::size_t k = 0; k < other.of.size(); ++k) of[k].merge(other.of[k]);
  }
};

struct NamedEasing {
  std::string set;
  std::string id;
  EasingCurve<float> curve;

  [[nodiscard]] bool rises() const { return curve.y1 >= 0 && curve.y1 <= 1 && curve.y2 >= 0 && curve.y2 <= 1; }
  [[nodiscard]] reference::ExactEased exact(float x) const { return {curve.x1, curve.y1, curve.x2, curve.y2, x}; }
};

/// The true y at one float.
struct TrueY {
  float nearest;
  double y;    ///< to 46 bits at least
  double ulp;  ///< of float, at y
};

/// The distance of floats at y, which is not 0.
double float_ulp(double y) {
  constexpr int smallest = -149;
  return std::ldexp(1.0, std::max(std::ilogb(y) - 23, smallest));
}

TrueY true_y(const NamedEasing& easing, reference::FloatEasing& enclosing, float x) {
  if (x > 0 && x < 1)
    if (const auto y = enclosing.at(x); y && y->decides())
      return {static_cast<float>(y->low), y->low + (y->high - y->low) / 2, float_ulp(y->low)};
  auto exact = easing.exact(x);
  const double y = exact.nearest(reference::binary64);
  return {static_cast<float>(exact.nearest(reference::binary32)), y, float_ulp(y == 0 ? 0x1p-149 : y)};
}

/// A curve and an interval are a part.
class EasingFloatsJob final : public run::JobOf<EasedFloatsOfMethods> {
 public:
  explicit EasingFloatsJob(const suite::Study& study) : study_(study) {
    for (const auto& set : study_.sets)
      for (std::size_t k = 0; k < set->curves.size(); ++k) {
        const auto found = easing_curve_of(set->curves[k]);
        if (!found) continue;
        curves_.push_back({set->id,
                           std::string(set->curves.id(k)),
                           {static_cast<float>(found->x1), static_cast<float>(found->y1), static_cast<float>(found->x2),
                            static_cast<float>(found->y2)}});
      }
    if (curves_.empty())
      suite::refuse(study_, {"curves", 0, "kind",
                             "the sets have no cubic from (0, 0) to (1, 1) with x1 and x2 in [0, 1]; name another"});
    std::vector<const MethodInfo*> infos;
    for (const auto& kernel : easing_kernels()) infos.push_back(kernel.info);
    const auto chosen = judge::chosen_companions(study_, infos);
    for (const auto& kernel : easing_kernels())
      if (kernel.info->bit_stable && std::ranges::find(chosen, kernel.info) != chosen.end())
        kernels_.push_back(&kernel);
    for (const auto& curve : curves_)
      for (std::size_t k = 0; k < study_.t_interval.size(); ++k) {
        const auto range = floats_in(study_.t_interval[k]);
        if (!range) suite::refuse(study_, {"t_interval", k, {}, "there is no float in this t_interval; widen it"});
        parts_.push_back({&curve, *range});
        blocks_ = std::max(blocks_, static_cast<std::size_t>((range->count() - 1) / floats_of_block + 1));
      }
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return blocks_; }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double points = static_cast<double>(parts_[part].range.count()) / static_cast<double>(blocks_);
    return points * (250 + 80 * static_cast<double>(kernels_.size()));
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (const auto& part : parts_) sum += {1, kernels_.size(), part.range.count() * kernels_.size()};
    return sum;
  }
  void write(tables::Tables& tables) const override;
  [[nodiscard]] std::vector<run::Violation> violations() const override;

 protected:
  [[nodiscard]] EasedFloatsOfMethods work(std::size_t block) const override {
    const auto& part = parts_[part_of(block)];
    const std::uint64_t number = block % blocks_;
    const auto begin = [&](std::uint64_t k) { return part.range.first + part.range.count() * k / blocks_; };
    EasedFloatsOfMethods tallies;
    tallies.of.resize(kernels_.size());
    reference::FloatEasing enclosing(part.easing->curve.x1, part.easing->curve.y1, part.easing->curve.x2,
                                     part.easing->curve.y2);
    for (std::uint64_t first = begin(number); first < begin(number + 1) && !run::interrupted(); first += floats_at_once)
      judge(part, enclosing, first, std::min(first + floats_at_once, begin(number + 1)), tallies.of);
    return tallies;
  }

 private:
  struct Part {
    const NamedEasing* easing;
    FloatRange range;
  };

  /// The floats with bits from `first` to `end` - 1, and the step from the float before them, if it is in the part.
  void judge(const Part& part, reference::FloatEasing& enclosing, std::uint64_t first, std::uint64_t end,
             std::vector<EasedFloats>& tallies) const {
    const std::size_t before = first > part.range.first ? 1 : 0;
    std::vector<float> x;
    for (std::uint64_t bits = first - before; bits < end; ++bits)
      x.push_back(float_of(static_cast<std::uint32_t>(bits)));
    std::vector<TrueY> truth;
    for (std::size_t k = before; k < x.size(); ++k) truth.push_back(true_y(*part.easing, enclosing, x[k]));
    std::vector<Eased<float>> eased(x.size());
    for (std::size_t m = 0; m < kernels_.size(); ++m) {
      kernels_[m]->ease_float(part.easing->curve, x, eased.data());
      EasedFloats& tally = tallies[m];
      for (std::size_t k = before; k < x.size(); ++k) {
        const auto& [nearest, y, ulp] = truth[k - before];
        const auto& one = eased[k];
        tally.misrounded += one.y == nearest ? 0 : 1;
        tally.not_converged += one.converged ? 0 : 1;
        tally.max_steps = std::max(tally.max_steps, static_cast<std::uint64_t>(one.steps));
        const double error = std::isfinite(one.y) ? std::abs(double{one.y} - y) / ulp : HUGE_VAL;
        tally.add_error(error, std::bit_cast<std::uint32_t>(x[k]));
        if (k > 0 && part.easing->rises() && eased[k].y < eased[k - 1].y) ++tally.non_monotone;
      }
    }
  }

  suite::Study study_;
  std::vector<NamedEasing> curves_;
  std::vector<const EasingKernel*> kernels_;
  std::vector<Part> parts_;
  std::size_t blocks_ = 1;
};

void EasingFloatsJob::write(tables::Tables& tables) const {
  (void)tables.table("easing_floats.csv");
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const auto& [easing, range] = parts_[part];
    for (std::size_t m = 0; m < kernels_.size(); ++m) {
      const EasedFloats& tally = state(part).of.at(m);
      const float worst = float_of(tally.worst_x);
      Eased<float> eased;
      kernels_[m]->ease_float(easing->curve, std::span(&worst, 1), &eased);
      const auto error = std::isfinite(eased.y)
                             ? tables::field(easing->exact(worst).error_ulp(eased.y, reference::binary32))
                             : tables::Field();
      tables.add(tables::Row("easing_floats.csv")
                     .set("study", study_.id)
                     .set("curve_id", easing->id)
                     .set("curves", easing->set)
                     .set("method", kernels_[m]->info->id)
                     .set("scalar", suite::name(suite::ScalarKind::float32))
                     .set("t_min", double{float_of(range.first)})
                     .set("t_max", double{float_of(range.last)})
                     .set("points", range.count())
                     .set("max_error_ulp", error)
                     .set("worst_x", tables::Hexadecimal{double{worst}})
                     .set("misrounded", tally.misrounded)
                     .set("non_monotone", easing->rises() ? std::optional(tally.non_monotone) : std::nullopt)
                     .set("max_steps", tally.max_steps)
                     .set("not_converged", tally.not_converged));
    }
  }
}

std::vector<run::Violation> EasingFloatsJob::violations() const {
  std::vector<run::Violation> all;
  for (std::size_t part = 0; part < parts_.size(); ++part)
    for (std::size_t m = 0; m < kernels_.size(); ++m) {
      const EasedFloats& tally = state(part).of.at(m);
      if (kernels_[m]->is_correctly_rounded && tally.misrounded + tally.non_monotone > 0)
        all.push_back(
            {fmt::format("study {}, curve {}, method {}", study_.id, parts_[part].easing->id, kernels_[m]->info->id),
             tally.misrounded + tally.non_monotone, run::Broken::promise});
    }
  return all;
}

std::unique_ptr<run::Job> easing_floats_job(const suite::Study& study, const run::JobContext& /*context*/) {
  return std::make_unique<EasingFloatsJob>(study);
}

constexpr std::array<std::string_view, 9> keys_not_of_floats{"dimension",  "coordinate_range", "generator",
                                                             "scalar",     "trials",           "replicates",
                                                             "parameters", "parameters_from",  "placement"};

}  // namespace

extern constexpr StudyKind easing_floats_kind{
    .asks = {.id = "easing_floats",
             .about = "every float x of an interval: y on the easing curves of sets",
             .own = {},
             .methods_example = "[\"easing_*\"]",
             .inputs = {.forms = suite::bernstein_form,
                        .forms_reason = "easing curves are given by control points",
                        .degree = suite::DegreeUse::not_a_key,
                        .degree_reason = "easing curves are cubics",
                        .parameters = suite::Parameters::from_0_to_1,
                        .parameters_reason = "x is in [0, 1]",
                        .sets = suite::SetUse::required},
             .without = keys_not_of_floats,
             .without_reason = "the curves are those of sets, methods compute in float, and every x is tried"},
    .make = easing_floats_job};

}  // namespace bezierbench::studies
