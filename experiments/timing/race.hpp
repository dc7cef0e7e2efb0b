// SPDX-License-Identifier: MIT
// Times rivals against each other: in every round each runs once, in an order that changes from round to round, so that
// drift of the machine meets all of them alike and ratios can be taken within rounds.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace bezierbench::timing {

/// One contestant. `run` does its whole batch once and writes its results where `check` looks.
struct Rival {
  std::string name;
  std::size_t points_per_batch;
  std::function<void()> run;
  std::function<bool()> check;  ///< outside the clock, after every round: are the results the judged ones?
};

struct Lap {
  std::vector<double> ns_per_point;  ///< one per round
  std::size_t points_per_round = 0;
  bool checked = true;  ///< every check held

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.ns_per_point, self.points_per_round, self.checked);
  }
};

struct RaceOptions {
  std::size_t rounds = 41;      ///< at least; rounded up so that every order of the rivals occurs equally often
  double round_seconds = 5e-4;  ///< least time of one rival in one round
  bool (*stop)() = nullptr;     ///< asked between rounds; true ends the race early
};

/// Runs the race as one Google Benchmark benchmark with manual time; laps are in the order of the rivals.
std::vector<Lap> race(const std::string& name, std::span<const Rival> rivals, const RaceOptions& options);

}  // namespace bezierbench::timing
