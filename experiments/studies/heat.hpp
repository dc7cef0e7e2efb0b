// SPDX-License-Identifier: MIT
// One cell of a timing study in one scalar type and mode: its methods race each other, with a sentinel beside them, in
// several sittings. They all answer one question, evaluation or that of a companion problem.
//
// What rounds of one race share (where the stack and the data lie, how fast the processor happens to be) varies from
// race to race, and the spread of rounds does not show it: two runs of the same program then differ by more than the
// intervals of either. So each heat is raced in sittings, spread over the study's time, each with memory allocated anew
// and the stack elsewhere, and a time's interval is that of the median over sittings. That the place of the stack alone
// can bias a time more than what is compared: Mytkowicz, Diwan, Hauswirth and Sweeney, Producing wrong data without
// doing anything obviously wrong (ASPLOS 2009), section 4.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/studies/asked.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/timing/race.hpp"
#include "experiments/timing/sentinel.hpp"

namespace bezierbench::studies {

/// So few that they cover the true median with timing_confidence, from the least to the greatest.
inline constexpr std::size_t sittings_per_heat = 8;

/// What a method, or the sentinel, has from the sittings of a heat.
struct HeatLap {
  timing::Lap rounds;              ///< of all sittings; the k-th of all methods of the heat is the same round
  std::vector<double> sitting_ns;  ///< medians of the sittings; the k-th of all methods of the heat is the same sitting

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.rounds, self.sitting_ns);
  }
};

/// What sittings of a heat gave: the lap of each method, then of the sentinel.
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

/// One sitting, 0 <= sitting < sittings_per_heat: judges the methods, then races them. A method whose points are wrong
/// is timed all the same, and not `checked`.
HeatLaps run(const Heat& heat, const suite::Study& study, std::uint64_t seed, std::size_t sitting,
             const timing::RaceOptions& options);

/// The sentinel's fastest sitting; infinite where none ran.
double fastest_sentinel(const std::vector<HeatLap>& laps);
/// The same over all heats.
double fastest_sentinel(const std::vector<Heat>& heats);

/// Whether the sentinel's median over sittings is slower than `fastest`, its fastest of the study, by more than is
/// tolerated.
bool drifted(const std::vector<HeatLap>& laps, double fastest);

/// The method id that a study names as its baseline; empty where it names none.
std::string named_baseline(const suite::Study& study);

/// Which of a heat's methods its ratios are relative to: the study's baseline or, if it names none, the first that the
/// study names and that supports the degree. Empty where the baseline is not in the race.
std::optional<std::size_t> relative_to(const Heat& heat, const suite::Study& study);

}  // namespace bezierbench::studies
