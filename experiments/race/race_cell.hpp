// SPDX-License-Identifier: MIT
// One cell of a timing study in one scalar type and mode: its methods race each other, with sentinels beside them, in
// several repetitions. All of them solve the same problem: evaluation or one companion problem.
//
// Repetitions are spread over the time of the whole suite, and intervals are over repetitions; repetition.hpp says why.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/judge/case_axes.hpp"
#include "experiments/race/operation_times.hpp"
#include "experiments/race/race.hpp"
#include "experiments/race/repetition.hpp"
#include "experiments/race/sentinel.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::race {

/// The laps of a method or a sentinel in the repetitions of a race cell.
struct RaceCellLap {
  /// Element k is the same repetition, with the same rounds, for all methods of the race cell.
  std::vector<Lap> repetitions;
  std::optional<double> max_error_u = std::nullopt;  ///< of the results where no bound is proved, in units of u p~

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.repetitions, self.max_error_u);
  }

  /// The rounds of all repetitions.
  [[nodiscard]] Lap rounds() const;
  /// The median of each repetition.
  [[nodiscard]] std::vector<double> repetition_ns() const;
};

/// The result of repetitions of a race cell: the laps of each method, of an empty kernel where the methods are
/// evaluators, then those of the sentinels.
struct RaceCellLaps {
  std::vector<RaceCellLap> each;
  std::vector<ProcessorTimes> operations = {};  ///< one measurement a repetition, beside evaluators

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.each, self.operations);
  }

  /// Adds other repetitions of the same race cell; their order does not matter.
  void merge(const RaceCellLaps& other);
};

struct TimedProblem;

struct RaceCell {
  sample::Cell cell;
  suite::ScalarKind scalar;
  suite::Mode mode;
  std::vector<const MethodInfo*> methods;       ///< those that support the degree
  judge::CaseValues case_values = {};           ///< of a companion problem
  std::vector<RaceCellLap> laps = {};           ///< see RaceCellLaps; empty until a repetition ran
  std::vector<ProcessorTimes> operations = {};  ///< likewise
};

/// Nanoseconds for one repetition, to an order of magnitude; see run::Job::cost. The limits of a race make it take
/// about the same time at every degree.
inline double repetition_cost(const RaceCell& race_cell) {
  constexpr double of_all_repetitions = 5e7;  // of one method
  return of_all_repetitions / repetitions_per_race * static_cast<double>(race_cell.methods.size());
}

/// The laps of the empty kernel; null where there was none.
const RaceCellLap* call_of(const RaceCell& race_cell);

/// One repetition, 0 <= repetition < repetitions_per_race: judges the methods, then races them. A method whose points
/// are wrong is timed all the same, and not `checked`. `trials` is kept from one repetition to the next
/// (timed_problem.hpp).
RaceCellLaps run(const TimedProblem& problem, const RaceCell& race_cell, const suite::Study& study, std::uint64_t seed,
                 std::size_t repetition, const RaceOptions& options, std::shared_ptr<const void>& trials);

/// The times of the two sentinels.
struct Pace {
  double chain_ns = std::numeric_limits<double>::infinity();
  double sweep_ns = std::numeric_limits<double>::infinity();

  /// Keeps the faster time of each sentinel.
  void speed_up(const Pace& other);
  /// The greater of the ratios to `other`.
  [[nodiscard]] double over(const Pace& other) const;
};

/// Medians over the repetitions that were run; `laps` holds some.
Pace pace(const std::vector<RaceCellLap>& laps);

/// The fastest repetition of each sentinel; infinite where none ran.
Pace fastest_pace(const std::vector<RaceCellLap>& laps);
/// The same over all race cells.
Pace fastest_pace(const std::vector<RaceCell>& race_cells);

/// Whether a sentinel's median over repetitions is slower than `fastest`, its fastest of the study, by more than is
/// tolerated.
bool drifted(const std::vector<RaceCellLap>& laps, const Pace& fastest);

/// Whether the repetitions of one method disagree: the slowest quarter of them takes longer than the fastest by more
/// than is tolerated. Then the median depends more on disturbances and on where memory lies than on the method.
bool repetitions_disagree(const RaceCellLap& lap);

/// The method id that a study names as its baseline; empty where it names none.
std::string named_baseline(const suite::Study& study);

/// Which of a race cell's methods its ratios are relative to: the study's baseline or, if it names none, the first that
/// the study names and that supports the degree. Empty where the baseline is not in the race.
std::optional<std::size_t> relative_to(const RaceCell& race_cell, const suite::Study& study);

}  // namespace bezierbench::race
