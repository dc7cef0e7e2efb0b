// SPDX-License-Identifier: MIT
// The base of all jobs of times: a race is a part. Its repetitions are blocks; where the study asks for counts, one more
// block counts its methods.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "experiments/failure.hpp"
#include "experiments/race/race.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/run/job.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

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
