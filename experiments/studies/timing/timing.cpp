// SPDX-License-Identifier: MIT
#include "experiments/studies/timing/timing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/race/clock.hpp"
#include "experiments/race/race_cell.hpp"
#include "experiments/race/timed_inputs.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/timing/complexity_rows.hpp"
#include "experiments/studies/timing/timed_problems.hpp"
#include "experiments/studies/timing/timing_rows.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::studies {
namespace {

constexpr int most_reruns_per_repetition = 2;

/// One race cell is a part, each of its repetitions a block.
class TimingJob final : public run::JobOf<race::RaceCellLaps> {
 public:
  TimingJob(const suite::Study& study, std::uint64_t seed)
      : study_(study),
        seed_(seed),
        race_cells_(timed_problem(study).race_cells(study)),
        reruns_left_(race_cells_.size() * race::repetitions_per_race / 2) {
    require_racing_baseline();
  }

  [[nodiscard]] std::size_t parts() const override { return race_cells_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return race::repetitions_per_race; }
  [[nodiscard]] bool exclusive() const override { return true; }
  void require_machine() const override { race::require_steady_clock(); }
  [[nodiscard]] double cost(std::size_t part) const override { return race::repetition_cost(race_cells_[part]); }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum{race_cells_.size(), suite::keys_of<suite::TimingKeys>(study_).modes.size(), 0,
                    0};  // a sentinel's row in each mode
    for (const auto& race_cell : race_cells_) {
      sum.rows += race_cell.methods.size();
      sum.evaluations += race_cell.methods.size() * race::timed_inputs_per_cell;
    }
    return sum;
  }
  void write(tables::Tables& tables) const override {
    write_timing_rows(study_, raced(), tables);
    write_complexity_rows(study_, raced(), timed_problem(study_).size, tables);
  }
  [[nodiscard]] std::vector<tables::Series> series() const override;

 protected:
  [[nodiscard]] race::RaceCellLaps work(std::size_t block) const override;

 private:
  /// The race cells with their laps so far.
  [[nodiscard]] std::vector<race::RaceCell> raced() const {
    auto race_cells = race_cells_;
    for (std::size_t part = 0; part < race_cells.size(); ++part) {
      race_cells[part].laps = state(part).each;
      race_cells[part].operations = state(part).operations;
    }
    return race_cells;
  }
  /// The sentinels' fastest repetitions in all results so far, those of an earlier run included when this one continues
  /// it.
  [[nodiscard]] race::Pace fastest_so_far() const {
    race::Pace fastest;
    for (std::size_t part = 0; part < race_cells_.size(); ++part)
      fastest.speed_up(race::fastest_pace(state(part).each));
    return fastest;
  }
  void require_racing_baseline() const;

  suite::Study study_;
  std::uint64_t seed_;
  std::vector<race::RaceCell> race_cells_;
  // Repetitions run one at a time, so these need no lock.
  mutable std::size_t reruns_left_;  ///< of the study, which reruns lengthen by half at most
  mutable race::Pace fastest_;       ///< sentinels of the study so far
  race::Counters counters_;
};

void TimingJob::require_racing_baseline() const {
  const auto named = race::named_baseline(study_);
  const auto races = [&](const race::RaceCell& race_cell) {
    return race_cell.methods.empty() ||
           std::ranges::any_of(race_cell.methods, [&](const auto* info) { return info->id == named; });
  };
  if (!named.empty() && std::ranges::none_of(race_cells_, races))
    suite::refuse(study_,
                  {"baseline", 0, "methods",
                   fmt::format("baseline \"{}\" is not among its methods; add it to them or leave it out", named)});
}

/// A repetition in which a sentinel drifted is run again. The attempt in which the sentinels were nearer to their
/// fastest times counts.
race::RaceCellLaps TimingJob::work(std::size_t block) const {
  const race::RaceCell& race_cell = race_cells_[part_of(block)];
  if (race_cell.methods.empty()) return {};  // none supports the degree
  fastest_.speed_up(fastest_so_far());
  const auto race = [&] {
    auto options = race::options_of_a_repetition();
    options.stop = run::interrupted;
    options.counters = &counters_;
    return race::run(timed_problem(study_), race_cell, study_, seed_, block % race::repetitions_per_race, options);
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
      all.push_back({.study = study_.id,
                     .curve = std::string(suite::name(study_.curve)),
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

}  // namespace

std::unique_ptr<run::Job> timing_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<TimingJob>(study, context.seed);
}

}  // namespace bezierbench::studies
