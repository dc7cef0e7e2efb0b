// SPDX-License-Identifier: MIT
// A race: the methods of one cell of a timing study, in one scalar type and mode, are timed against each other and
// against sentinels. All of them solve the same problem: evaluation or one companion problem.
//
// A race is run in repetitions, which are spread over the time of the whole suite. A repetition allocates its own
// memory for results and prepared states, and has its own stack offset. Statistics of a time or a ratio are over
// repetitions.
//
// The rounds of one repetition share conditions (addresses of stack and data, speed of the processor) that differ
// between repetitions. The spread of the rounds does not show that difference: an interval from all rounds, as if
// they were independent, would become ever narrower around the conditions of one run. So each repetition is one
// observation: its median over rounds, in which all rivals met the same conditions. Kalibera and Jones, Rigorous
// benchmarking in reasonable time (ISMM 2013), section 4, say why to repeat the highest level that varies. Hurlbert,
// Pseudoreplication and the design of ecological field experiments (Ecological Monographs 54, 1984, 187-211), says
// what becomes of intervals if dependent observations count as independent. Mytkowicz, Diwan, Hauswirth and Sweeney,
// Producing wrong data without doing anything obviously wrong (ASPLOS 2009), section 4, show that the address of the
// stack alone can bias a time by more than the difference that is compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/method.hpp"
#include "experiments/judge/case_axes.hpp"
#include "experiments/race/counts.hpp"
#include "experiments/race/limit.hpp"
#include "experiments/race/rounds.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::race {

/// Enough repetitions that the median's interval of metric::timing_confidence leaves out the smallest and the largest
/// one, which other processes may have disturbed: 2 (1 + 12) / 2^12 = 0.6 %. With 8 to 11 it is the whole range. No
/// distribution is assumed; Student's interval on logarithms would be a tenth narrower for a normal distribution, which
/// repetitions do not have.
inline constexpr std::size_t repetitions_per_race = 12;

/// The limits of one race, divided among its repetitions.
RaceOptions repetition_options();

/// Median over the rounds of one repetition.
double median_ns(const RoundTimes& repetition);

/// Median over the rounds of one repetition of the time over another rival's in the same round.
double median_ratio(const RoundTimes& repetition, const RoundTimes& base);

/// These ratios for each repetition; both rivals took part in all of them.
std::vector<double> repetition_ratios(std::span<const RoundTimes> repetitions, std::span<const RoundTimes> base);

// Runs code with an offset of its stack. Local arrays that straddle cache lines, or share sets of a cache with the
// data, cost time that is not the method's, so several offsets are tried.

/// Calls `body()` with the stack 528 * step bytes further down: each step has another 16-byte offset within a cache
/// line and another eighth of a page. step < 1024.
template <class Body>
[[gnu::noinline]] auto with_stack_moved(std::size_t step, Body&& body) {
  constexpr std::size_t bytes_per_step = 528;
  auto* room = static_cast<volatile char*>(__builtin_alloca(bytes_per_step * step + 1));
  *room = 0;  // keeps the compiler from removing the allocation
  return std::forward<Body>(body)();
}

/// The times of a rival, a method or a sentinel, in the repetitions of a race.
struct RivalTimes {
  /// Element k is the same repetition, with the same rounds, for all methods of the race.
  std::vector<RoundTimes> repetitions;
  std::optional<double> max_error_u = std::nullopt;  ///< of the results where no bound is proved, in units of u p~

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.repetitions, self.max_error_u);
  }

  /// The rounds of all repetitions.
  [[nodiscard]] RoundTimes rounds() const;
  /// The median of each repetition.
  [[nodiscard]] std::vector<double> repetition_ns() const;
};

/// The times of the rivals of a race: of each method, of an empty kernel where the methods are evaluators, then of the
/// sentinels.
struct RaceTimes {
  std::vector<RivalTimes> each;
  std::vector<ProcessorTimes> operations = {};  ///< one measurement a repetition, beside evaluators
  std::vector<Cost> counts = {};                ///< of the methods; empty where they were not counted

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.each, self.operations, self.counts);
  }

  /// Adds other repetitions of the same race; their order does not matter.
  void merge(const RaceTimes& other);
};

struct Race {
  sample::Cell cell;
  suite::ScalarKind scalar;
  suite::Mode mode;
  std::vector<const MethodInfo*> methods;       ///< those that support the degree
  judge::CaseValues case_values = {};           ///< of a companion problem
  std::vector<RivalTimes> times = {};           ///< see RaceTimes; empty before the first repetition
  std::vector<ProcessorTimes> operations = {};  ///< likewise
  std::vector<Cost> counts = {};                ///< likewise
};

/// The size that the claimed costs of a problem's methods grow with.
enum class Size { unclaimed, degree, points };

/// The judgement of the results that a rival must reproduce.
struct RivalJudgement {
  bool right = true;
  std::optional<double> max_error_u = std::nullopt;  ///< as in JudgedPoints
};

struct JudgedRivals {
  std::vector<Rival> rivals;
  std::vector<RivalJudgement> judged;        ///< of each
  std::shared_ptr<const void> inputs;        ///< the inputs that the rivals read
  std::optional<Rival> call = std::nullopt;  ///< an empty kernel, beside evaluators
};

/// A problem that a timing study can time: evaluation, or a companion problem, whose methods the study then names in
/// place of evaluators. The kind of study that judges the problem states it (timed_companion.hpp).
struct TimedProblem {
  Size size;
  /// The races of a study, before any repetition. Throws Failure(usage) for studies that cannot be timed.
  std::vector<Race> (*races)(const suite::Study& study);
  /// One rival for each method of the race. `trials` is kept from one call for the race to
  /// the next, null for the first: the trials of a companion problem, whose truths take longer than their race.
  JudgedRivals (*rivals)(const Race& race, const suite::Study& study, std::uint64_t seed,
                         std::shared_ptr<const void>& trials);
};

/// Nanoseconds for one repetition, to an order of magnitude; see run::Job::cost. The limits of a race make it take
/// about the same time at every degree.
inline double repetition_cost(const Race& race) {
  constexpr double method_cost = 5e7;  // of all repetitions
  return method_cost / repetitions_per_race * static_cast<double>(race.methods.size());
}

/// The times of the empty kernel; null where there was none.
const RivalTimes* call_times(const Race& race);

/// One repetition among rivals that were judged beforehand, with the sentinels. A rival whose results were wrong is not
/// `checked`.
RaceTimes run_rivals(const Race& race, const suite::Study& study, JudgedRivals judged, std::size_t repetition,
                     const RaceOptions& options);

/// The times of the two sentinels.
struct SentinelTimes {
  double chain_ns = std::numeric_limits<double>::infinity();
  double sweep_ns = std::numeric_limits<double>::infinity();

  /// The greater of the ratios to `other`.
  [[nodiscard]] double over(const SentinelTimes& other) const;
};

/// The faster time of each sentinel.
SentinelTimes min(const SentinelTimes& a, const SentinelTimes& b);

/// Medians over repetitions; `times` are those of a RaceTimes with one repetition or more.
SentinelTimes median_sentinels(const std::vector<RivalTimes>& times);

/// The fastest repetition of each sentinel; infinite without repetitions.
SentinelTimes fastest_sentinels(const std::vector<RivalTimes>& times);

/// Whether the median of a sentinel over the repetitions exceeds `fastest`, its fastest time in the study, by more than
/// the tolerance.
bool drifted(const std::vector<RivalTimes>& times, const SentinelTimes& fastest);

/// The method id that a study names as its baseline; empty where it names none.
std::string named_baseline(const suite::Study& study);

/// Which of a race's methods its ratios are relative to: the study's baseline or, if it names none, the first that
/// the study names and that supports the degree. Empty where the baseline is not in the race.
std::optional<std::size_t> relative_to(const Race& race, const suite::Study& study);

}  // namespace bezierbench::race
