// SPDX-License-Identifier: MIT
// Studies of kind `timing`: the methods of a study race each other in every cell and mode.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "experiments/race/kernel_rival.hpp"
#include "experiments/race/race.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/external/external.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/timing/timing_rows.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/validate.hpp"

namespace bezierbench::studies {
namespace {

constexpr int max_reruns_per_repetition = 2;

class TimingJob final : public RacingJob<race::RaceTimes> {
 public:
  TimingJob(const suite::Study& study, const run::JobContext& context)
      : RacingJob(study, context, timed_problem(study).races(study)), reruns_left_(blocks() / 2), trials_(parts()) {
    require_racing_baseline();
  }

  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum{races().size(), 0, 0};
    for (const auto& race : races()) sum.rows += race.methods.size();
    sum.evaluations = sum.rows * race::timed_inputs_per_cell;
    return sum;
  }
  void write(tables::Tables& tables) const override {
    const auto races = raced();
    if (repetitions() > 0) {
      write_timing_rows(study(), races, tables);
      write_complexity_rows(study(), races, timed_problem(study()).size, tables);
    }
    if (counts()) write_cost_rows(study(), races, tables);
  }
  [[nodiscard]] std::vector<tables::Series> series() const override;

 protected:
  [[nodiscard]] race::RaceTimes work(std::size_t block) const override;
  [[nodiscard]] race::JudgedRivals rivals_of(std::size_t part) const override {
    return timed_problem(study()).rivals(races()[part], study(), seed(), trials_[part]);
  }

 private:
  /// The races with their times so far.
  [[nodiscard]] std::vector<race::Race> raced() const {
    return RacingJob::raced([this](std::size_t part) -> const race::RaceTimes& { return state(part); });
  }
  /// The sentinels' fastest repetitions in all results so far, including those of the run that this one continues.
  [[nodiscard]] race::SentinelTimes fastest_so_far() const {
    race::SentinelTimes fastest;
    for (std::size_t part = 0; part < races().size(); ++part)
      fastest = min(fastest, race::fastest_sentinels(state(part).each));
    return fastest;
  }
  void require_racing_baseline() const;

  // Repetitions run one at a time, so these need no lock.
  mutable std::size_t reruns_left_;      ///< of the study, reruns add at most half of its repetitions
  mutable race::SentinelTimes fastest_;  ///< sentinels of the study so far
  mutable std::vector<std::shared_ptr<const void>> trials_;  ///< of each race, see race::TimedProblem
  race::Counters counters_;
};

void TimingJob::require_racing_baseline() const {
  const auto named = race::named_baseline(study());
  const auto has_baseline = [&](const race::Race& race) {
    return race.methods.empty() ||
           std::ranges::any_of(race.methods, [&](const auto* info) { return info->id == named; });
  };
  if (!named.empty() && std::ranges::none_of(races(), has_baseline))
    suite::refuse(study(),
                  {"baseline", 0, "methods",
                   fmt::format("baseline \"{}\" is not among its methods; add it to them or leave it out", named)});
}

/// Runs a repetition again where a sentinel drifted, and keeps the attempt in which the sentinels were nearer to their
/// fastest times.
race::RaceTimes TimingJob::work(std::size_t block) const {
  const race::Race& race = races()[part_of(block)];
  if (race.methods.empty()) return {};  // no method supports the degree
  if (is_count(block)) return counted(part_of(block));
  fastest_ = min(fastest_, fastest_so_far());
  const auto run_once = [&] {
    auto options = race::repetition_options();
    options.stop = run::interrupted;
    options.counters = &counters_;
    return race::run_rivals(race, study(), rivals_of(part_of(block)), repetition_of(block), options);
  };
  race::RaceTimes times = run_once();
  for (int rerun = 0; rerun < max_reruns_per_repetition && reruns_left_ > 0; ++rerun) {
    if (run::interrupted()) break;
    fastest_ = min(fastest_, race::fastest_sentinels(times.each));
    if (!race::drifted(times.each, fastest_)) break;
    --reruns_left_;
    auto again = run_once();
    if (race::median_sentinels(again.each).over(fastest_) < race::median_sentinels(times.each).over(fastest_))
      times = std::move(again);
  }
  return times;
}

/// Races in double only; the source report prints no scalar type.
std::vector<tables::Series> TimingJob::series() const {
  std::vector<tables::Series> all;
  if (repetitions() == 0) return all;
  const auto races = raced();
  for (const auto& race : races)
    for (std::size_t m = 0; m < race.methods.size() && race.scalar == suite::ScalarKind::float64; ++m)
      all.push_back({.study = study().id,
                     .form = std::string(name(study().form)),
                     .method = std::string(race.methods[m]->id),
                     .statistic = "total_time",
                     .degree = std::to_string(race.cell.degree),
                     .coordinate_range = race.cell.coordinate_range,
                     .t_interval = race.cell.t_interval,
                     .generator = race.cell.generator,
                     .baseline = "",
                     .mode = std::string(suite::name(race.mode)),
                     .values = race.times[m].rounds().ns_per_point});
  return all;
}

std::unique_ptr<run::Job> timing_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<TimingJob>(study, context);
}

constexpr std::array timing_fields{
    suite::field<&suite::Study::modes>(
        {.key = "modes",
         .meaning = "what one timed call does: one_shot prepares and evaluates one point, point evaluates one prepared "
                    "point, latency a chain of them, batch many t; companion problems are timed in one_shot only",
         .example = "[\"point\"]"}),
    suite::field<&suite::Study::order>(suite::optional(suite::order_key, "none; only methods of derivatives have it")),
    suite::field<&suite::Study::points>(
        suite::optional(suite::points_key, "none; only methods of interpolation and fitting have it")),
    suite::field<&suite::Study::tolerance>(suite::optional(
        suite::tolerance_key("tolerances, relative to the length for lengths, distances for fits", "[1e-3, 1e-6]"),
        "none; only methods of lengths and fitting have it")),
    suite::field<&suite::Study::counts>(
        {.key = "counts",
         .meaning =
             "whether the instructions, loads, stores and branches of a point are counted, which takes Valgrind: "
             "none, beside_times, or only",
         .example = "\"beside_times\"",
         .left_out = "none",
         .settable = false}),
    suite::field<&suite::Study::published>(suite::published_key)};

suite::Finding check_timing(const suite::Study& study) {
  if (!study.degree.empty() || !study.points.empty() || suite::has_sets(study)) return std::nullopt;
  return suite::Fault{
      "degree", 0, {}, "degree is missing; kind \"timing\" requires degree or points; add degree = [3, 5]"};
}

}  // namespace

extern constexpr StudyKind timing_kind{.asks = {.id = "timing",
                                                .about = "time per evaluation or per answer to a companion problem",
                                                .own = timing_fields,
                                                .methods_example = "[\"de_casteljau\", \"horner_bernstein\"]",
                                                .inputs = {.degree = suite::DegreeUse::optional},
                                                .timed = true,
                                                .has_baseline = true,
                                                .check = check_timing},
                                       .make = timing_job,
                                       .make_external = external_timing_job};

}  // namespace bezierbench::studies
