// SPDX-License-Identifier: MIT
// What all jobs of times have in common: a race cell is a part, each of its repetitions a block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "experiments/race/clock.hpp"
#include "experiments/race/race_cell.hpp"
#include "experiments/run/job.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

template <class State>
class RacingJob : public run::JobOf<State> {
 public:
  RacingJob(suite::Study study, std::uint64_t seed, std::vector<race::RaceCell> race_cells)
      : study_(std::move(study)), seed_(seed), race_cells_(std::move(race_cells)) {}

  [[nodiscard]] std::size_t parts() const override { return race_cells_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return race::repetitions_per_race; }
  [[nodiscard]] bool exclusive() const override { return true; }
  void require_machine() const override { race::require_steady_clock(); }
  [[nodiscard]] double cost(std::size_t part) const override { return race::repetition_cost(race_cells_[part]); }

 protected:
  [[nodiscard]] const suite::Study& study() const { return study_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] const std::vector<race::RaceCell>& race_cells() const { return race_cells_; }
  /// The race cells with the laps that `laps_of(part)` has of them.
  template <class LapsOf>
  [[nodiscard]] std::vector<race::RaceCell> raced(const LapsOf& laps_of) const {
    auto raced = race_cells_;
    for (std::size_t part = 0; part < raced.size(); ++part) {
      const race::RaceCellLaps& laps = laps_of(part);
      raced[part].laps = laps.each;
      raced[part].operations = laps.operations;
    }
    return raced;
  }

 private:
  suite::Study study_;
  std::uint64_t seed_;
  std::vector<race::RaceCell> race_cells_;
};

}  // namespace bezierbench::studies
