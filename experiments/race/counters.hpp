// SPDX-License-Identifier: MIT
// The processor's own counters of cycles and instructions, where the machine lets this process read them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace bezierbench::race {

struct Counts {
  double cycles;
  double instructions;
};

/// A reading of the group, in the layout of `perf_event_open(2)`.
struct CounterReading {
  std::uint64_t members = 0;
  std::uint64_t enabled_ns = 0;  ///< since the counters were opened
  std::uint64_t running_ns = 0;  ///< the part of it in which they counted: processes share the counters
  std::uint64_t cycles = 0;
  std::uint64_t instructions = 0;
};

/// Counts between two readings, scaled up by enabled / running time. Empty where the counters did not run in between.
std::optional<Counts> counts_between(const CounterReading& before, const CounterReading& after);

/// A group of two counters, cycles and instructions of this thread in user mode. Counts while the object lives.
class Counters {
 public:
  Counters();
  ~Counters();
  Counters(const Counters&) = delete;
  Counters& operator=(const Counters&) = delete;
  Counters(Counters&&) = delete;
  Counters& operator=(Counters&&) = delete;

  /// `cycles, instructions`, or `unavailable: ` and why.
  [[nodiscard]] const std::string& state() const { return state_; }
  [[nodiscard]] bool available() const { return group_ >= 0; }
  /// Empty where they are not available.
  [[nodiscard]] std::optional<CounterReading> read() const;

 private:
  /// Why they are not available; empty where they are.
  std::string open();
  void close();

  int group_ = -1;
  int instructions_ = -1;
  std::string state_;
};

}  // namespace bezierbench::race
