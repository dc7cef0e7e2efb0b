// SPDX-License-Identifier: MIT
// Times rivals against each other. In every round each runs once, in an order that changes from round to round. Drift
// of the machine therefore affects all rivals equally, and ratios are taken within rounds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "experiments/race/counters.hpp"

namespace bezierbench::race {

/// Nanoseconds since a fixed moment.
using Clock = std::int64_t (*)();

/// std::chrono::steady_clock.
std::int64_t steady_ns();

/// The minimum time of one rival in one round, unless the options of a race say otherwise.
inline constexpr double min_round_seconds = 5e-5;

/// One rival. `run` does its whole batch once and writes the results that `check` reads.
struct Rival {
  std::string name;
  std::size_t points_per_batch;
  std::function<void()> run;
  std::function<bool()> check;  ///< after every round, not timed: true where the results are the judged ones
  std::string target = {};      ///< of a batch kernel: the instruction set
};

/// The times of one rival in the rounds of one repetition.
struct RoundTimes {
  std::vector<double> ns_per_point;            ///< one per round
  std::vector<double> cycles_per_point;        ///< one per round in which the counters ran; none without counters
  std::vector<double> instructions_per_point;  ///< likewise
  std::size_t points_per_round = 0;            ///< the largest number, of several repetitions
  bool checked = true;                         ///< every check held

  /// Appends the rounds of another repetition of the same rival.
  void append(const RoundTimes& other);

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.ns_per_point, self.cycles_per_point, self.instructions_per_point, self.points_per_round, self.checked);
  }
};

/// Many short rounds measure better than few long ones: a round shorter than the scheduler's time slice is seldom
/// interrupted, and all rivals of the round meet the same state of the machine. On two processors with a load of
/// 12, half the interval of the ratio of a kernel to itself was 68 % with 41 rounds of 0.5 ms and 0.07 % with 400
/// rounds of 0.05 ms, in half the time.
struct RaceOptions {
  std::size_t rounds = 400;                  ///< at most, approximately
  std::size_t min_rounds = 41;               ///< before `rival_seconds` may end the race
  double round_seconds = min_round_seconds;  ///< minimum time of one rival in one round
  double rival_seconds = 0.04;               ///< of one rival in all rounds, on average
  double max_seconds = 30;                   ///< the race ends after the round that reaches this, in any case
  Clock clock = steady_ns;
  const Counters* counters = nullptr;
  bool (*stop)() = nullptr;  ///< called between rounds; true ends the race early
};

/// Runs the rounds as one Google Benchmark benchmark with manual time; the times are in the order of the rivals. Unless
/// `max_seconds` or `stop` end it, every order of the rivals has occurred equally often.
std::vector<RoundTimes> time_rounds(const std::string& name, std::span<const Rival> rivals, const RaceOptions& options);

// Fixed work that runs beside every race: when it takes longer, the machine changed, not the methods.
//
// There are two sentinels, because a disturbance may slow only one of them. Another thread on the same core takes half
// of its arithmetic units, but not the cycles in which a chain waits for its last result. The chain, x <- 1 - 1 x, is
// bound by latency: every step waits for the one before, one product and one difference. The sweep is bound by
// throughput: it does the same steps on many independent numbers, which take as long as the core needs to issue, load,
// compute and store. Started from 1/4, x alternates between 3/4 and 1/4 without rounding, so that the results are
// known.

/// The name of the chain in timing.csv, which also states times in units of it.
inline constexpr std::string_view sentinel_name = "sentinel";

/// The chain as a rival; a point is one step.
Rival chain_sentinel();
/// The sweep; a point is one step of one number.
Rival sweep_sentinel();

/// Both sentinels in the order in which they end the list of rivals: the sweep, then the chain.
std::array<Rival, 2> sentinels();

// A vector that begins at a given offset within a page of 4096 bytes, so that corresponding data of all rivals have the
// same offset.
//
// A processor first compares the addresses of a load and of pending stores by their offsets within a page. A load after
// a store at the same offset of another page may wait for it needlessly, so the allocator could make one of two equal
// kernels faster. Sources: AMD, Software Optimization Guide 25112, section 5.5, on false dependencies; Intel, IA-32
// Optimization Reference Manual, section 2, on aliasing by multiples of 4 kilobytes.

inline constexpr std::size_t page = 4096;

template <class T, std::size_t Place>
struct AtPagePlace {
  static_assert(Place < page && Place % alignof(T) == 0);
  using value_type = T;
  template <class U>
  struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
    using other = AtPagePlace<U, Place>;
  };

  AtPagePlace() = default;
  template <class U>
  explicit AtPagePlace(const AtPagePlace<U, Place>& /*other*/) {}

  T* allocate(std::size_t count) {
    auto* pages = static_cast<std::byte*>(::operator new(Place + count * sizeof(T), std::align_val_t(page)));
    return reinterpret_cast<T*>(pages + Place);
  }
  void deallocate(T* values, std::size_t /*count*/) {
    ::operator delete(reinterpret_cast<std::byte*>(values) - Place, std::align_val_t(page));
  }

  friend bool operator==(const AtPagePlace& /*a*/, const AtPagePlace& /*b*/) { return true; }
};

/// Begins `Place` bytes into a page.
template <class T, std::size_t Place>
using PageVector = std::vector<T, AtPagePlace<T, Place>>;

}  // namespace bezierbench::race
