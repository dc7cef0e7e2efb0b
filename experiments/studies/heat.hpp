// SPDX-License-Identifier: MIT
// One cell of a timing study in one scalar type and mode: its methods race each other, with sentinels beside them, in
// several sittings. They all answer one question, evaluation or that of a companion problem.
//
// Sittings are spread over the time of the whole suite, and intervals are over sittings; timing/sitting.hpp says why.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/studies/asked.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/timing/race.hpp"
#include "experiments/timing/sentinel.hpp"
#include "experiments/timing/sitting.hpp"

namespace bezierbench::studies {

/// What a method, or a sentinel, has from the sittings of a heat.
struct HeatLap {
  /// The k-th of all methods of the heat is the same sitting, and its rounds are the same rounds.
  std::vector<timing::Lap> sittings;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.sittings);
  }

  /// The rounds of all sittings.
  [[nodiscard]] timing::Lap rounds() const;
  /// The median of each sitting.
  [[nodiscard]] std::vector<double> sitting_ns() const;
};

/// What sittings of a heat gave: the lap of each method, then of the sentinels.
struct HeatLaps {
  std::vector<HeatLap> each;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.each);
  }

  /// Other sittings of the same heat, in whatever order they come.
  void merge(const HeatLaps& other);
};

struct Heat {
  sample::Cell cell;
  suite::ScalarKind scalar;
  suite::Mode mode;
  std::vector<const MethodInfo*> methods;  ///< those that support the degree
  Asked asked = {};                        ///< of a companion problem
  std::vector<HeatLap> laps = {};          ///< what it gave, see HeatLaps; empty where none ran
};

/// The heats of a study, none of which ran. Throws Failure(usage) for what cannot be timed.
std::vector<Heat> heats_of(const suite::Study& study);

/// One sitting, 0 <= sitting < timing::sittings_per_race: judges the methods, then races them. A method whose points
/// are wrong is timed all the same, and not `checked`.
HeatLaps run(const Heat& heat, const suite::Study& study, std::uint64_t seed, std::size_t sitting,
             const timing::RaceOptions& options);

/// How long the sentinels took.
struct Pace {
  double chain_ns = std::numeric_limits<double>::infinity();
  double sweep_ns = std::numeric_limits<double>::infinity();

  /// Takes over what is faster.
  void speed_up(const Pace& other);
  /// The greater of the ratios to `other`.
  [[nodiscard]] double over(const Pace& other) const;
};

/// Medians over the sittings that were run; `laps` holds some.
Pace pace(const std::vector<HeatLap>& laps);

/// Each sentinel's fastest sitting; infinite where none ran.
Pace fastest_pace(const std::vector<HeatLap>& laps);
/// The same over all heats.
Pace fastest_pace(const std::vector<Heat>& heats);

/// Whether a sentinel's median over sittings is slower than `fastest`, its fastest of the study, by more than is
/// tolerated.
bool drifted(const std::vector<HeatLap>& laps, const Pace& fastest);

/// Whether the sittings of one method disagree: the slowest quarter of them takes longer than the fastest by more than
/// is tolerated. Then the median says which part of the time was quiet, or where the memory lay, more than what the
/// method takes.
bool sittings_disagree(const HeatLap& lap);

/// The method id that a study names as its baseline; empty where it names none.
std::string named_baseline(const suite::Study& study);

/// Which of a heat's methods its ratios are relative to: the study's baseline or, if it names none, the first that the
/// study names and that supports the degree. Empty where the baseline is not in the race.
std::optional<std::size_t> relative_to(const Heat& heat, const suite::Study& study);

}  // namespace bezierbench::studies
