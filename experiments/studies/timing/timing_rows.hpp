// SPDX-License-Identifier: MIT
// timing.csv: the times of a study's races, a row per method, and a row per mode for the sentinel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/failure.hpp"
#include "experiments/race/race.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/run/job.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

/// Races without repetitions have no rows. Times are medians over repetitions, also in units of the sentinel of the
/// same repetition (`sentinel_units`), with their intervals; so are ratios, each the median over the rounds of a
/// repetition. Of evaluators `limit_ns` is the least time that this processor could take, and `share_of_limit` the part
/// that it is of the time without that of an empty kernel, `call_ns`. `quality` is `unchecked` where a timed result was
/// not the judged one, `few_rounds` where there are too few repetitions for an interval, else `ok`. `sentinel_ns` and
/// `sweep_ns` are the times of the two sentinels. The sentinel's row is over all races of its mode, so it has no
/// dimension or degree.
void write_timing_rows(const suite::Study& study, const std::vector<race::Race>& races, tables::Tables& tables);

/// The row of the method at place `method` of a race that ran. Its ratio is to the method at place `base`.
void add_timing_row(tables::Tables& tables, const suite::Study& study, const race::Race& race, std::size_t method,
                    std::optional<std::size_t> base);

// cost.csv: what the processor does for a point, as Callgrind counts it; a row per method of every race that was counted.

void write_cost_rows(const suite::Study& study, const std::vector<race::Race>& races, tables::Tables& tables);

/// The row of the method at place `method` of a race that was counted.
void add_cost_row(tables::Tables& tables, const suite::Study& study, const race::Race& race, std::size_t method);

// complexity.csv: the growth of a study's times with the degree or the number of points, against the claims of its
// methods.

/// One row per method, scalar type, dimension and mode that ran at three different sizes or more: the exponent is that
/// of the degree or, where first_points and last_points are not empty, of the number of points. `claimed` is the
/// method's cost_exponent; in mode one_shot, where a curve is prepared for every point, the larger of that and its
/// prepare_exponent. A problem whose methods claim no exponent has no rows.
void write_complexity_rows(const suite::Study& study, const std::vector<race::Race>& races, race::Size size,
                           tables::Tables& tables);

// The base of all jobs of times: a race is a part. Its repetitions are blocks; where the study asks for counts, one more
// block counts its methods.

template <class State>
class RacingJob : public run::JobOf<State> {
 public:
  RacingJob(suite::Study study, run::JobContext context, std::vector<race::Race> races)
      : study_(std::move(study)), context_(std::move(context)), races_(std::move(races)) {}

  [[nodiscard]] std::size_t parts() const override { return races_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return repetitions() + (counts() ? 1 : 0); }
  [[nodiscard]] bool exclusive() const override { return true; }
  [[nodiscard]] double cost(std::size_t part) const override { return race::repetition_cost(races_[part]); }
  void count() const override {
    if (!counts()) return;
    for (std::size_t part = 0; part < parts(); ++part)
      if (!races_[part].methods.empty()) {
        const auto judged = rivals_of(part);
        race::count(judged.rivals, context_.number, part);
      }
  }

 protected:
  /// The rivals of a race, which are also counted: one for each method.
  [[nodiscard]] virtual race::JudgedRivals rivals_of(std::size_t part) const = 0;

  [[nodiscard]] const suite::Study& study() const { return study_; }
  [[nodiscard]] std::uint64_t seed() const { return context_.seed; }
  [[nodiscard]] const std::vector<race::Race>& races() const { return races_; }
  [[nodiscard]] std::size_t repetitions() const {
    return study_.counts == suite::Counting::only ? 0 : race::repetitions_per_race;
  }
  [[nodiscard]] bool counts() const { return study_.counts != suite::Counting::none; }
  /// Whether a block counts; else it is the repetition of its number in its part.
  [[nodiscard]] bool is_count(std::size_t block) const { return block % blocks_per_part() == repetitions(); }
  [[nodiscard]] std::size_t repetition_of(std::size_t block) const { return block % blocks_per_part(); }

  /// The counts of a race. A child counts all races of the run when the first of them is counted.
  [[nodiscard]] race::RaceTimes counted(std::size_t part) const {
    if (races_[part].methods.empty()) return {};
    if (counted_.empty()) {
      const auto files = context_.count_jobs();
      if (run::interrupted()) return {};
      counted_ = race::read_counts(files, context_.number);
    }
    if (counted_.size() <= part || counted_[part].size() != races_[part].methods.size())
      throw Failure(Exit::environment, study_.id + ": Callgrind did not count every method; see --counts");
    return {.each = {}, .operations = {}, .counts = counted_[part]};
  }

  /// The races with the times and counts that `times_of(part)` has of them.
  template <class LapsOf>
  [[nodiscard]] std::vector<race::Race> raced(const LapsOf& times_of) const {
    auto raced = races_;
    for (std::size_t part = 0; part < raced.size(); ++part) {
      const race::RaceTimes& times = times_of(part);
      raced[part].times = times.each;
      raced[part].operations = times.operations;
      raced[part].counts = times.counts;
    }
    return raced;
  }

 private:
  suite::Study study_;
  run::JobContext context_;
  std::vector<race::Race> races_;
  mutable std::vector<std::vector<race::Cost>> counted_;  ///< blocks of these jobs run one at a time
};

}  // namespace bezierbench::studies
