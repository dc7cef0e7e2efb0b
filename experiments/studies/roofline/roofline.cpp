// SPDX-License-Identifier: MIT
// Studies of kind `roofline`: batch kernels against the peak of each target, measured in the same rounds.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/operations/operations.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/race/limit.hpp"
#include "experiments/race/timed_inputs.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/roofline/roofline_race.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/goal.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {

namespace {

constexpr std::string_view scalar_kernel = "scalar";

metric::Interval interval(std::span<const double> sample) {
  return metric::median_interval(sample, metric::timing_confidence);
}

/// The goal of a rival's row.
struct Goal {
  std::optional<double> share;  ///< of the peak, at least
  std::optional<double> ns;     ///< per point, at most
};

/// One race, with the fields that its rows share.
class Race {
 public:
  explicit Race(const RooflineRace& race) : race_(race) {}

  [[nodiscard]] const race::RoundTimes* lap(Work work, const batch::Target* target, std::string_view id = {}) const {
    for (std::size_t k = 0; k < race_.rivals.size(); ++k) {
      const auto& who = race_.rivals[k];
      if (who.work == work && who.target == target && (who.method == nullptr || who.method->id == id))
        return &race_.times.each[k];
    }
    return nullptr;
  }

  /// What an empty kernel took.
  [[nodiscard]] double call_ns(suite::Mode mode) const {
    const auto is_call = [mode](const TargetRival& who) { return who.work == Work::call && who.mode == mode; };
    const auto found = std::ranges::find_if(race_.rivals, is_call);
    return interval(race_.times.each[static_cast<std::size_t>(found - race_.rivals.begin())].ns_per_point).median;
  }

  /// Operations per nanosecond.
  [[nodiscard]] double peak(Work work, const batch::Target* target) const {
    return 1 / interval(lap(work, target)->ns_per_point).median;
  }

  /// The goals of the study that apply to this row.
  [[nodiscard]] Goal goal(const TargetRival& who, const std::vector<suite::Goal>& goals) const {
    Goal case_values;
    for (const auto& one : goals) {
      if (!is_about(one, who)) continue;
      if (one.share > 0) case_values.share = one.share;
      const auto* rival = lap(Work::scalar_points, nullptr, one.no_slower_than);
      if (!one.no_slower_than.empty() && rival != nullptr) case_values.ns = interval(rival->ns_per_point).median;
    }
    return case_values;
  }

 private:
  [[nodiscard]] bool is_about(const suite::Goal& goal, const TargetRival& who) const {
    const int degree = race_.cell.degree;
    if (goal.method != who.method->id || goal.scalar != race_.scalar) return false;
    if (degree < goal.from_degree || degree > goal.to_degree) return false;
    return !goal.needs_additions_beside ||
           peak(Work::multiply_add_and_add, who.target) > peak(Work::multiply_add, who.target);
  }

  const RooflineRace& race_;
};

/// The share of a target's peak that a lap of a method reached.
metric::Interval share(const race::RoundTimes& lap, const race::RoundTimes& peak, double flops) {
  std::vector<double> shares;
  for (std::size_t round = 0; round < lap.ns_per_point.size(); ++round)
    shares.push_back(flops * peak.ns_per_point[round] / lap.ns_per_point[round]);
  return interval(shares);
}

/// The fastest time of each target's peak in any race of a study, in each scalar type: ns per operation.
using Fastest = std::map<std::pair<const batch::Target*, suite::ScalarKind>, double>;

Fastest fastest_peaks(const std::vector<RooflineRace>& races) {
  Fastest fastest;
  for (const auto& race : races)
    for (std::size_t k = 0; k < race.times.each.size(); ++k) {
      if (race.rivals[k].work != Work::multiply_add) continue;
      const double ns = interval(race.times.each[k].ns_per_point).median;
      const auto [place, is_first] = fastest.try_emplace({race.rivals[k].target, race.scalar}, ns);
      if (!is_first) place->second = std::min(place->second, ns);
    }
  return fastest;
}

/// Empty where they are not counted.
std::optional<double> flops_of(const RooflineRace& race, const TargetRival& who) {
  const auto count = point_operations(*who.evaluator, race.cell.degree, race.cell.dimension, Layout::points);
  return count ? std::optional(count->flops()) : std::nullopt;
}

/// Of a target only what its vectors can do; a kernel for one point has all widths of the processor.
race::ProcessorTimes times_of(const RooflineRace& race, const TargetRival& who) {
  auto times = race.times.operations;
  if (who.target == nullptr) return times;
  const auto lanes = judge::with_scalar(
      race.scalar, [&]<class Scalar>(Scalar /*zero*/) { return batch::works_of<Scalar>(*who.target).back().lanes; });
  std::erase_if(times, [lanes](const race::OperationTimes& width) { return width.lanes > lanes; });
  return times;
}

void set_limit(tables::Row& row, const RooflineRace& race, const TargetRival& who, double ns) {
  const double call = Race(race).call_ns(who.mode);
  row.set("call_ns", call);
  const auto limit =
      race::limit({who.evaluator, nullptr, race.cell.degree, race.cell.dimension}, who.mode, times_of(race, who));
  if (!limit) return;
  row.set("limit_ns", limit->ns)
      .set("share_of_limit", race::share_of_limit(limit->ns, ns, call))
      .set("chain_ns", limit->chain_ns);
}

/// What only a kernel of a target has: its share of the peak, and the goals of its row.
void set_share(tables::Row& row, const suite::Study& study, const RooflineRace& race, std::size_t place,
               const Fastest& fastest) {
  const auto& who = race.rivals[place];
  const auto& lap = race.times.each[place];
  const Race all(race);
  const double peak = all.peak(Work::multiply_add, who.target);
  const auto used = share(lap, *all.lap(Work::multiply_add, who.target), *flops_of(race, who));
  const auto goal = all.goal(who, study.goals);
  row.set("peak_gflops", peak)
      .set("mixed_peak_gflops", all.peak(Work::multiply_add_and_add, who.target))
      .set("share_of_peak", used.median)
      .set("share_low", used.low)
      .set("share_high", used.high)
      .set("goal_share", goal.share)
      .set("goal_ns", goal.ns);
  const double ns = interval(lap.ns_per_point).median;
  const bool met = (!goal.share || used.median >= *goal.share) && (!goal.ns || ns <= *goal.ns);
  if (goal.share || goal.ns) row.set("goal_met", met ? "yes" : "no");
  const bool steady = 1 / peak <= (1 + metric::tolerated_drift) * fastest.at({who.target, race.scalar});
  row.set("quality", steady ? "ok" : "noisy");
}

tables::Row key_row(const suite::Study& study, const RooflineRace& race, const TargetRival& who) {
  tables::Row row("roofline.csv");
  row.set("study", study.id)
      .set("form", name(study.form))
      .set("method", who.method->id)
      .set("scalar", suite::name(race.scalar))
      .set("dimension", race.cell.dimension)
      .set("degree", race.cell.degree)
      .set("target", who.target == nullptr ? scalar_kernel : who.target->name)
      .set("mode", suite::name(who.mode))
      .set_each(tables::drawn_columns(), tables::drawn_fields(race.cell));
  return row;
}

tables::Row row_of(const suite::Study& study, const RooflineRace& race, std::size_t place, const Fastest& fastest) {
  const auto& who = race.rivals[place];
  const auto& lap = race.times.each[place];
  const auto ns = interval(lap.ns_per_point);
  const auto flops = flops_of(race, who);
  tables::Row row = key_row(study, race, who);
  row.set("median_ns", ns.median)
      .set("low_ns", ns.low)
      .set("high_ns", ns.high)
      .set("flops", flops)
      .set("gflops", flops ? std::optional(*flops / ns.median) : std::nullopt)
      .set("rounds", lap.ns_per_point.size())
      .set("checked", lap.checked ? "yes" : "no");
  set_limit(row, race, who, ns.median);
  if (who.target != nullptr) set_share(row, study, race, place, fastest);
  return row;
}

}  // namespace

void list_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables) {
  for (const auto& race : races)
    for (const auto& who : race.rivals)
      if (who.method != nullptr) tables.add(key_row(study, race, who));
}

void write_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables) {
  (void)tables.table("roofline.csv");
  const auto fastest = fastest_peaks(races);
  for (const auto& race : races)
    for (std::size_t k = 0; k < race.times.each.size(); ++k)
      if (race.rivals[k].method != nullptr) tables.add(row_of(study, race, k, fastest));
}

namespace {

class RooflineJob final : public run::JobOf<RooflineTimes> {
 public:
  RooflineJob(const suite::Study& study, std::uint64_t seed)
      : study_(study), seed_(seed), races_(roofline_races_of(study)) {}

  [[nodiscard]] std::size_t parts() const override { return races_.size(); }
  [[nodiscard]] bool exclusive() const override { return true; }
  [[nodiscard]] double cost(std::size_t part) const override {
    return 5e7 * static_cast<double>(races_[part].rivals.size());  // about the same wall time whatever the degree
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum{races_.size(), 0, 0};
    for (const auto& race : races_)
      for (const auto& who : race.rivals)
        if (who.method != nullptr) {
          ++sum.rows;
          sum.evaluations += race::timed_inputs_per_cell;
        }
    return sum;
  }
  void write(tables::Tables& tables) const override {
    auto races = races_;
    for (std::size_t part = 0; part < races.size(); ++part) races[part].times = state(part);
    write_roofline_rows(study_, races, tables);
  }
  void list_rows(tables::Tables& tables) const override { list_roofline_rows(study_, races_, tables); }
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }

 protected:
  [[nodiscard]] RooflineTimes work(std::size_t block) const override {
    if (races_[block].rivals.empty()) return {};  // no method supports the degree, or no target is there
    race::RaceOptions options;
    options.stop = run::interrupted;
    return run(races_[block], study_, seed_, options);
  }

 private:
  suite::Study study_;
  std::uint64_t seed_;
  std::vector<RooflineRace> races_;
};

std::unique_ptr<run::Job> roofline_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<RooflineJob>(study, context.seed);
}

constexpr std::array roofline_fields{suite::field<&suite::Study::goals>(
    {.key = "goals",
     .meaning = "what batch kernels must reach: of a method, a share of the peak or no_slower_than another method; "
                "scalar, from_degree and to_degree say in which rows, needs_additions_beside on which processors",
     .example = "[{ method = \"horner_bernstein_fma\", share = 0.6 }]",
     .left_out = "none",
     .settable = false})};

suite::Finding check_roofline(const suite::Study& study, const suite::Vocabulary& known) {
  return suite::each("goals", study.goals,
                     [&](const suite::Goal& goal) { return suite::goal_problem(goal, known.methods); });
}

}  // namespace

extern constexpr StudyKind roofline_kind{
    .asks = {.id = "roofline",
             .about = "batch kernels against the peak of each instruction set, kernels for a point against its limit",
             .own = roofline_fields,
             .methods_example = "[\"horner_bernstein_fma\"]",
             .inputs = {.sets = suite::SetUse::none, .sets_reason = "times do not depend on the curves"},
             .timed = true,
             .check = check_roofline},
    .make = roofline_job,
    .tables = {"roofline"}};

}  // namespace bezierbench::studies
