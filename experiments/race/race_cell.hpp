// SPDX-License-Identifier: MIT
// One cell of a timing study in one scalar type and mode: its methods race each other, with sentinels beside them, in
// several repetitions. They all answer one question, evaluation or that of a companion problem.
//
// Repetitions are spread over the time of the whole suite, and intervals are over repetitions; timing/repetition.hpp
// says why.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/judge/case_axes.hpp"
#include "experiments/race/race.hpp"
#include "experiments/race/repetition.hpp"
#include "experiments/race/sentinel.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::race {

/// What a method, or a sentinel, has from the repetitions of a race cell.
struct RaceCellLap {
  /// The k-th of all methods of the race cell is the same repetition, and its rounds are the same rounds.
  std::vector<Lap> repetitions;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.repetitions);
  }

  /// The rounds of all repetitions.
  [[nodiscard]] Lap rounds() const;
  /// The median of each repetition.
  [[nodiscard]] std::vector<double> repetition_ns() const;
};

/// What repetitions of a race cell gave: the lap of each method, then of the sentinels.
struct RaceCellLaps {
  std::vector<RaceCellLap> each;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.each);
  }

  /// Other repetitions of the same race cell, in whatever order they come.
  void merge(const RaceCellLaps& other);
};

struct TimedProblem;

struct RaceCell {
  sample::Cell cell;
  suite::ScalarKind scalar;
  suite::Mode mode;
  std::vector<const MethodInfo*> methods;  ///< those that support the degree
  judge::CaseValues case_values = {};      ///< of a companion problem
  std::vector<RaceCellLap> laps = {};      ///< what it gave, see RaceCellLaps; empty where none ran
};

/// One repetition, 0 <= repetition < repetitions_per_race: judges the methods, then races them. A method whose points
/// are wrong is timed all the same, and not `checked`.
RaceCellLaps run(const TimedProblem& problem, const RaceCell& race_cell, const suite::Study& study, std::uint64_t seed,
                 std::size_t repetition, const RaceOptions& options);

/// How long the sentinels took.
struct Pace {
  double chain_ns = std::numeric_limits<double>::infinity();
  double sweep_ns = std::numeric_limits<double>::infinity();

  /// Takes over what is faster.
  void speed_up(const Pace& other);
  /// The greater of the ratios to `other`.
  [[nodiscard]] double over(const Pace& other) const;
};

/// Medians over the repetitions that were run; `laps` holds some.
Pace pace(const std::vector<RaceCellLap>& laps);

/// Each sentinel's fastest repetition; infinite where none ran.
Pace fastest_pace(const std::vector<RaceCellLap>& laps);
/// The same over all race cells.
Pace fastest_pace(const std::vector<RaceCell>& race_cells);

/// Whether a sentinel's median over repetitions is slower than `fastest`, its fastest of the study, by more than is
/// tolerated.
bool drifted(const std::vector<RaceCellLap>& laps, const Pace& fastest);

/// Whether the repetitions of one method disagree: the slowest quarter of them takes longer than the fastest by more
/// than is tolerated. Then the median says which part of the time was quiet, or where the memory lay, more than what
/// the method takes.
bool repetitions_disagree(const RaceCellLap& lap);

/// The method id that a study names as its baseline; empty where it names none.
std::string named_baseline(const suite::Study& study);

/// Which of a race cell's methods its ratios are relative to: the study's baseline or, if it names none, the first that
/// the study names and that supports the degree. Empty where the baseline is not in the race.
std::optional<std::size_t> relative_to(const RaceCell& race_cell, const suite::Study& study);

}  // namespace bezierbench::race
