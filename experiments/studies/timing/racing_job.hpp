// SPDX-License-Identifier: MIT
// The base of all jobs of times: a race is a part, each of its repetitions a block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "experiments/race/race.hpp"
#include "experiments/run/job.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

template <class State>
class RacingJob : public run::JobOf<State> {
 public:
  RacingJob(suite::Study study, std::uint64_t seed, std::vector<race::Race> races)
      : study_(std::move(study)), seed_(seed), races_(std::move(races)) {}

  [[nodiscard]] std::size_t parts() const override { return races_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return race::repetitions_per_race; }
  [[nodiscard]] bool exclusive() const override { return true; }
  [[nodiscard]] double cost(std::size_t part) const override { return race::repetition_cost(races_[part]); }

 protected:
  [[nodiscard]] const suite::Study& study() const { return study_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] const std::vector<race::Race>& races() const { return races_; }
  /// The races with the times that `times_of(part)` has of them.
  template <class LapsOf>
  [[nodiscard]] std::vector<race::Race> raced(const LapsOf& times_of) const {
    auto raced = races_;
    for (std::size_t part = 0; part < raced.size(); ++part) {
      const race::RaceTimes& times = times_of(part);
      raced[part].times = times.each;
      raced[part].operations = times.operations;
    }
    return raced;
  }

 private:
  suite::Study study_;
  std::uint64_t seed_;
  std::vector<race::Race> races_;
};

}  // namespace bezierbench::studies
