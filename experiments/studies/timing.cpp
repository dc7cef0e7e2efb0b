// SPDX-License-Identifier: MIT
#include "experiments/studies/timing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/failure.hpp"
#include "experiments/studies/complexity_rows.hpp"
#include "experiments/studies/heat.hpp"
#include "experiments/studies/interruption.hpp"
#include "experiments/studies/timed_inputs.hpp"
#include "experiments/studies/timed_problem.hpp"
#include "experiments/studies/timing_rows.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::studies {
namespace {

constexpr int most_reruns_per_sitting = 2;

/// One heat is a part, each of its sittings a block.
class TimingJob final : public JobOf<HeatLaps> {
 public:
  TimingJob(const suite::Study& study, std::uint64_t seed)
      : study_(study),
        seed_(seed),
        heats_(heats_of(study)),
        reruns_left_(heats_.size() * timing::sittings_per_race / 2) {
    require_racing_baseline();
  }

  [[nodiscard]] std::size_t parts() const override { return heats_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return timing::sittings_per_race; }
  [[nodiscard]] bool exclusive() const override { return true; }
  [[nodiscard]] double cost(std::size_t part) const override {
    // about the same wall time whatever the degree
    return 5e7 / timing::sittings_per_race * static_cast<double>(heats_[part].methods.size());
  }
  [[nodiscard]] Extent extent() const override {
    Extent sum{heats_.size(), study_.modes.size(), 0, 0};  // a sentinel's row in each mode
    for (const auto& heat : heats_) {
      sum.rows += heat.methods.size();
      sum.evaluations += heat.methods.size() * timed_inputs_per_cell;
    }
    return sum;
  }
  void write(Tables& tables) const override {
    write_timing_rows(study_, raced(), tables);
    write_complexity_rows(study_, raced(), timed_problem(study_).size, tables);
  }
  [[nodiscard]] std::vector<Series> series() const override;

 protected:
  [[nodiscard]] HeatLaps work(std::size_t block) const override;

 private:
  /// The heats with what they gave so far.
  [[nodiscard]] std::vector<Heat> raced() const {
    auto heats = heats_;
    for (std::size_t part = 0; part < heats.size(); ++part) heats[part].laps = state(part).each;
    return heats;
  }
  /// The sentinels' fastest sittings in all results so far, those of an earlier run included when this one continues
  /// it.
  [[nodiscard]] Pace fastest_so_far() const {
    Pace fastest;
    for (std::size_t part = 0; part < heats_.size(); ++part) fastest.speed_up(fastest_pace(state(part).each));
    return fastest;
  }
  void require_racing_baseline() const;

  suite::Study study_;
  std::uint64_t seed_;
  std::vector<Heat> heats_;
  // Sittings run one at a time, so these need no lock.
  mutable std::size_t reruns_left_;  ///< of the study: a restless machine lengthens it by half at most
  mutable Pace fastest_;             ///< sentinels of the study so far
  timing::Counters counters_;
};

void TimingJob::require_racing_baseline() const {
  const auto named = named_baseline(study_);
  const auto races = [&](const Heat& heat) {
    return heat.methods.empty() ||
           std::ranges::any_of(heat.methods, [&](const auto* info) { return info->id == named; });
  };
  if (!named.empty() && std::ranges::none_of(heats_, races))
    throw Failure(Exit::usage, fmt::format("study \"{}\": baseline \"{}\" is not among its methods; add it to them or "
                                           "leave it out",
                                           study_.id, named));
}

/// A sitting in which a sentinel drifted is run again; the attempt in which they were nearer to their fastest counts.
HeatLaps TimingJob::work(std::size_t block) const {
  const Heat& heat = heats_[part_of(block)];
  if (heat.methods.empty()) return {};  // none supports the degree
  fastest_.speed_up(fastest_so_far());
  const auto race = [&] {
    auto options = timing::options_of_a_sitting();
    options.stop = interrupted;
    options.counters = &counters_;
    return run(heat, study_, seed_, block % timing::sittings_per_race, options);
  };
  HeatLaps laps = race();
  for (int rerun = 0; rerun < most_reruns_per_sitting && reruns_left_ > 0; ++rerun) {
    if (interrupted()) break;
    fastest_.speed_up(fastest_pace(laps.each));
    if (!drifted(laps.each, fastest_)) break;
    --reruns_left_;
    auto again = race();
    if (pace(again.each).over(fastest_) < pace(laps.each).over(fastest_)) laps = std::move(again);
  }
  return laps;
}

/// Of the double heats only: printed times do not say otherwise.
std::vector<Series> TimingJob::series() const {
  std::vector<Series> all;
  const auto heats = raced();
  for (const auto& heat : heats)
    for (std::size_t m = 0; m < heat.methods.size() && heat.scalar == suite::ScalarKind::float64; ++m)
      all.push_back({.study = study_.id,
                     .curve = std::string(suite::name(study_.curve)),
                     .method = std::string(heat.methods[m]->id),
                     .statistic = "total_time",
                     .degree = std::to_string(heat.cell.degree),
                     .coordinate_range = heat.cell.coordinate_range,
                     .t_interval = heat.cell.t_interval,
                     .generator = heat.cell.generator,
                     .baseline = "",
                     .mode = std::string(suite::name(heat.mode)),
                     .values = heat.laps[m].rounds().ns_per_point});
  return all;
}

}  // namespace

std::unique_ptr<Job> timing_job(const suite::Study& study, const JobContext& context) {
  return std::make_unique<TimingJob>(study, context.seed);
}

}  // namespace bezierbench::studies
