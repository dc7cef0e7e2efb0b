// SPDX-License-Identifier: MIT
// Studies of kind `timing`: the methods of a study race each other in every cell and mode.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "experiments/race/race_cell.hpp"
#include "experiments/race/timed_inputs.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/timing/racing_job.hpp"
#include "experiments/studies/timing/timing_rows.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/keys.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::studies {
namespace {

constexpr int most_reruns_per_repetition = 2;

class TimingJob final : public RacingJob<race::RaceCellLaps> {
 public:
  TimingJob(const suite::Study& study, std::uint64_t seed)
      : RacingJob(study, seed, timed_problem(study).race_cells(study)), reruns_left_(blocks() / 2), trials_(parts()) {
    require_racing_baseline();
  }

  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum{race_cells().size(), 0, 0};
    for (const auto& race_cell : race_cells()) sum.rows += race_cell.methods.size();
    sum.evaluations = sum.rows * race::timed_inputs_per_cell;
    return sum;
  }
  void write(tables::Tables& tables) const override {
    write_timing_rows(study(), raced(), tables);
    write_complexity_rows(study(), raced(), timed_problem(study()).size, tables);
  }
  void list_rows(tables::Tables& tables) const override { list_timing_rows(study(), race_cells(), tables); }
  [[nodiscard]] std::vector<tables::Series> series() const override;

 protected:
  [[nodiscard]] race::RaceCellLaps work(std::size_t block) const override;

 private:
  /// The race cells with their laps so far.
  [[nodiscard]] std::vector<race::RaceCell> raced() const {
    return RacingJob::raced([this](std::size_t part) -> const race::RaceCellLaps& { return state(part); });
  }
  /// The sentinels' fastest repetitions in all results so far, those of an earlier run included when this one continues
  /// it.
  [[nodiscard]] race::Pace fastest_so_far() const {
    race::Pace fastest;
    for (std::size_t part = 0; part < race_cells().size(); ++part)
      fastest.speed_up(race::fastest_pace(state(part).each));
    return fastest;
  }
  void require_racing_baseline() const;

  // Repetitions run one at a time, so these need no lock.
  mutable std::size_t reruns_left_;                          ///< of the study, which reruns lengthen by half at most
  mutable race::Pace fastest_;                               ///< sentinels of the study so far
  mutable std::vector<std::shared_ptr<const void>> trials_;  ///< of each race cell, see race::run
  race::Counters counters_;
};

void TimingJob::require_racing_baseline() const {
  const auto named = race::named_baseline(study());
  const auto races = [&](const race::RaceCell& race_cell) {
    return race_cell.methods.empty() ||
           std::ranges::any_of(race_cell.methods, [&](const auto* info) { return info->id == named; });
  };
  if (!named.empty() && std::ranges::none_of(race_cells(), races))
    suite::refuse(study(),
                  {"baseline", 0, "methods",
                   fmt::format("baseline \"{}\" is not among its methods; add it to them or leave it out", named)});
}

/// A repetition in which a sentinel drifted is run again. The attempt in which the sentinels were nearer to their
/// fastest times counts.
race::RaceCellLaps TimingJob::work(std::size_t block) const {
  const race::RaceCell& race_cell = race_cells()[part_of(block)];
  if (race_cell.methods.empty()) return {};  // none supports the degree
  fastest_.speed_up(fastest_so_far());
  const auto race = [&] {
    auto options = race::options_of_a_repetition();
    options.stop = run::interrupted;
    options.counters = &counters_;
    return race::run(timed_problem(study()), race_cell, study(), seed(), block % race::repetitions_per_race, options,
                     trials_[part_of(block)]);
  };
  race::RaceCellLaps laps = race();
  for (int rerun = 0; rerun < most_reruns_per_repetition && reruns_left_ > 0; ++rerun) {
    if (run::interrupted()) break;
    fastest_.speed_up(race::fastest_pace(laps.each));
    if (!race::drifted(laps.each, fastest_)) break;
    --reruns_left_;
    auto again = race();
    if (race::pace(again.each).over(fastest_) < race::pace(laps.each).over(fastest_)) laps = std::move(again);
  }
  return laps;
}

/// Race cells in double only; the source report prints no scalar type.
std::vector<tables::Series> TimingJob::series() const {
  std::vector<tables::Series> all;
  const auto race_cells = raced();
  for (const auto& race_cell : race_cells)
    for (std::size_t m = 0; m < race_cell.methods.size() && race_cell.scalar == suite::ScalarKind::float64; ++m)
      all.push_back({.study = study().id,
                     .form = std::string(name(study().form)),
                     .method = std::string(race_cell.methods[m]->id),
                     .statistic = "total_time",
                     .degree = std::to_string(race_cell.cell.degree),
                     .coordinate_range = race_cell.cell.coordinate_range,
                     .t_interval = race_cell.cell.t_interval,
                     .generator = race_cell.cell.generator,
                     .baseline = "",
                     .mode = std::string(suite::name(race_cell.mode)),
                     .values = race_cell.laps[m].rounds().ns_per_point});
  return all;
}

std::unique_ptr<run::Job> timing_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<TimingJob>(study, context.seed);
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
    suite::field<&suite::Study::published>(suite::published_key)};

suite::Finding check_timing(const suite::Study& study, const suite::Vocabulary& known) {
  if (study.degree.empty() && study.points.empty())
    return suite::Fault{"degree", 0, {}, "degree is missing; kind \"timing\" needs it or points, add degree = [3, 5]"};
  if (auto found = suite::each("modes", study.modes, [](suite::Mode) { return std::string(); })) return found;
  if (auto found = suite::check_orders(study.order)) return found;
  if (auto found = suite::check_points(study.points)) return found;
  if (auto found = suite::check_tolerances(study.tolerance)) return found;
  return suite::check_published(study.published, known);
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
                                       .tables = {"timing"}};

}  // namespace bezierbench::studies
