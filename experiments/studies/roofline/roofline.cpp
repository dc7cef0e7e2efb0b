// SPDX-License-Identifier: MIT
// Studies of kind `roofline`: batch kernels against the peak of each target, measured in the same rounds.
#include "experiments/studies/roofline/roofline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/operations/operations.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/metric/observed_error.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/race/kernel_rival.hpp"
#include "experiments/race/race.hpp"
#include "experiments/race/timed_check.hpp"
#include "experiments/race/timed_inputs.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/goal.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

template <class Scalar>
std::vector<TargetRival> rivals_of(const suite::Study& study, const sample::Cell& cell) {
  std::vector<TargetRival> methods;
  const auto targets = batch::usable_targets();
  for (const auto* kernel : judge::chosen_kernels<Scalar>(study, cell)) {
    if (!kernel->info->template supports<Scalar>(cell.degree)) continue;
    for (const auto* target : targets)
      if (batch::find(*target, *kernel))
        methods.push_back({Work::batch_points, target, kernel->info, kernel->evaluator});
  }
  if (methods.empty()) return {};
  std::vector<TargetRival> all;
  for (const auto* target : targets)
    for (const auto work : {Work::multiply_add, Work::multiply_add_and_add}) all.push_back({work, target});
  all.insert(all.end(), methods.begin(), methods.end());
  return all;
}

template <class Scalar>
race::Rival rival_of(const TargetRival& who, const Kernel<Scalar>* kernel, const race::Inputs<Scalar>& inputs,
                     const race::JudgedPoints<Scalar>& judged) {
  switch (who.work) {
    case Work::batch_points: return race::batch_rival(*who.target, *kernel, inputs, judged.points);
    case Work::multiply_add: return race::peak_rival(batch::works_of<Scalar>(*who.target).back().multiply_add());
    case Work::multiply_add_and_add: break;
  }
  return race::peak_rival(batch::works_of<Scalar>(*who.target).back().multiply_add_and_add);
}

/// No accuracy study says what errors of a method without a proved bound may be.
template <class Scalar>
bool is_right(const race::JudgedPoints<Scalar>& judged) {
  const double allowed = metric::allowed_error_u(std::nullopt, judge::ScalarFacts<Scalar>::arithmetic.unit_roundoff);
  return judged.right && judged.max_error_u.value_or(0) <= allowed;
}

template <class Scalar>
RooflineTimes times_of(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                       const race::RaceOptions& options) {
  const auto inputs = race::timed_inputs<Scalar>(study, race.cell, seed);
  std::map<const MethodInfo*, race::JudgedPoints<Scalar>> judged;
  std::vector<race::Rival> rivals;
  for (const auto& who : race.rivals) {
    const Kernel<Scalar>* kernel = nullptr;
    if (who.method != nullptr) {
      kernel = judge::find_method<Scalar>(who.method->id, who.method->form, race.cell.dimension);
      if (!judged.contains(who.method)) judged[who.method] = race::judge_points(*kernel, suite::Mode::batch, inputs);
    }
    rivals.push_back(rival_of<Scalar>(who, kernel, inputs, judged[who.method]));
  }
  auto times = race::time_rounds(fmt::format("{}/{}", study.id, race.cell.degree), rivals, options);
  for (std::size_t k = 0; k < times.size(); ++k)
    times[k].checked = times[k].checked && is_right<Scalar>(judged[race.rivals[k].method]);
  return times;
}

}  // namespace

std::vector<RooflineRace> roofline_races_of(const suite::Study& study) {
  std::vector<RooflineRace> races;
  for (const auto scalar : study.scalar)
    for (const auto& cell : sample::cells(study))
      races.push_back(
          {cell, scalar,
           scalar == suite::ScalarKind::float32 ? rivals_of<float>(study, cell) : rivals_of<double>(study, cell)});
  return races;
}

RooflineTimes run(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                  const race::RaceOptions& options) {
  return judge::with_scalar(
      race.scalar, [&]<class Scalar>(Scalar /*zero*/) { return times_of<Scalar>(race, study, seed, options); });
}

namespace {

metric::Interval interval(std::span<const double> sample) {
  return metric::median_interval(sample, metric::timing_confidence);
}

/// The times of a target's peak in the race.
const race::RoundTimes& peak_times(const RooflineRace& race, Work work, const batch::Target* target) {
  const auto found = std::ranges::find_if(
      race.rivals, [&](const TargetRival& who) { return who.work == work && who.target == target; });
  return race.times[static_cast<std::size_t>(found - race.rivals.begin())];
}

/// In operations per nanosecond.
double peak(const RooflineRace& race, Work work, const batch::Target* target) {
  return 1 / median_ns(peak_times(race, work, target));
}

bool is_about(const suite::Goal& goal, const RooflineRace& race, const TargetRival& who) {
  const int degree = race.cell.degree;
  if (goal.method != who.method->id || goal.scalar != race.scalar) return false;
  if (degree < goal.from_degree || degree > goal.to_degree) return false;
  return !goal.needs_additions_beside ||
         peak(race, Work::multiply_add_and_add, who.target) > peak(race, Work::multiply_add, who.target);
}

/// The share of the peak that the last of the goals about this row requires.
std::optional<double> goal_share(const std::vector<suite::Goal>& goals, const RooflineRace& race,
                                 const TargetRival& who) {
  std::optional<double> share;
  for (const auto& goal : goals)
    if (is_about(goal, race, who)) share = goal.share;
  return share;
}

/// The share of a target's peak that a method reached, round by round.
metric::Interval share(const race::RoundTimes& method, const race::RoundTimes& peak, double flops) {
  std::vector<double> shares;
  for (std::size_t round = 0; round < method.ns_per_point.size(); ++round)
    shares.push_back(flops * peak.ns_per_point[round] / method.ns_per_point[round]);
  return interval(shares);
}

tables::Row key_row(const suite::Study& study, const RooflineRace& race, const TargetRival& who) {
  tables::Row row("roofline.csv");
  row.set("study", study.id)
      .set("form", name(study.form))
      .set("method", who.method->id)
      .set("scalar", suite::name(race.scalar))
      .set("dimension", race.cell.dimension)
      .set("degree", race.cell.degree)
      .set("target", who.target->name)
      .set_each(tables::drawn_columns(), tables::drawn_fields(race.cell));
  return row;
}

tables::Row row_of(const suite::Study& study, const RooflineRace& race, std::size_t place) {
  const auto& who = race.rivals[place];
  const auto& lap = race.times[place];
  const auto& peak_lap = peak_times(race, Work::multiply_add, who.target);
  const auto ns = interval(lap.ns_per_point);
  const double flops = point_operations(*who.evaluator, race.cell.degree, race.cell.dimension, Layout::points)->flops();
  const auto used = share(lap, peak_lap, flops);
  const auto goal = goal_share(study.goals, race, who);
  tables::Row row = key_row(study, race, who);
  row.set("median_ns", ns.median)
      .set("low_ns", ns.low)
      .set("high_ns", ns.high)
      .set("flops", flops)
      .set("gflops", flops / ns.median)
      .set("peak_gflops", peak(race, Work::multiply_add, who.target))
      .set("mixed_peak_gflops", peak(race, Work::multiply_add_and_add, who.target))
      .set("share_of_peak", used.median)
      .set("share_low", used.low)
      .set("share_high", used.high)
      .set("goal_share", goal)
      .set("rounds", lap.ns_per_point.size())
      .set("checked", lap.checked ? "yes" : "no");
  if (goal) row.set("goal_met", used.median >= *goal ? "yes" : "no");
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
  for (const auto& race : races)
    for (std::size_t k = 0; k < race.times.size(); ++k)
      if (race.rivals[k].method != nullptr) tables.add(row_of(study, race, k));
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
     .meaning =
         "what batch kernels must reach: of a method, a share of the peak; scalar, from_degree and to_degree say "
         "in which rows, needs_additions_beside on which processors",
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
             .about = "batch kernels against the peak of each instruction set",
             .own = roofline_fields,
             .methods_example = "[\"horner_bernstein_fma\"]",
             .inputs = {.sets = suite::SetUse::none, .sets_reason = "times do not depend on the curves"},
             .timed = true,
             .check = check_roofline},
    .make = roofline_job,
    .tables = {"roofline"}};

}  // namespace bezierbench::studies
