// SPDX-License-Identifier: MIT
#include "experiments/timing/race.hpp"

#include <benchmark/benchmark.h>

#include <chrono>

namespace bezierbench::timing {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_of(const Rival& rival, std::size_t repetitions) {
  const auto start = Clock::now();
  for (std::size_t k = 0; k < repetitions; ++k) {
    rival.run();
    benchmark::ClobberMemory();  // the results are read, as far as the compiler knows
  }
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Batches per round so that one rival takes at least `least_seconds`; doubling also warms it up.
std::size_t calibrated_repetitions(const Rival& rival, double least_seconds) {
  std::size_t repetitions = 1;
  while (seconds_of(rival, repetitions) < least_seconds) repetitions *= 2;
  return repetitions;
}

/// Google Benchmark prints nothing: the laps are the result.
class SilentReporter final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& /*runs*/) override {}
};

}  // namespace

std::vector<Lap> race(const std::string& name, std::span<const Rival> rivals, const RaceOptions& options) {
  std::vector<Lap> laps(rivals.size());
  std::vector<std::size_t> repetitions;
  for (const auto& rival : rivals) repetitions.push_back(calibrated_repetitions(rival, options.round_seconds));

  const auto body = [&](benchmark::State& state) {
    std::size_t round = 0;
    for ([[maybe_unused]] auto iteration : state) {
      double round_seconds = 0;
      for (std::size_t place = 0; place < rivals.size(); ++place) {
        // Rotated by the round and, every other round, reversed: each rival meets each place and each predecessor.
        const std::size_t shifted = (place + round / 2) % rivals.size();
        const std::size_t who = round % 2 == 0 ? shifted : rivals.size() - 1 - shifted;
        const double seconds = seconds_of(rivals[who], repetitions[who]);
        const auto points = repetitions[who] * rivals[who].points_per_batch;
        laps[who].ns_per_point.push_back(seconds * 1e9 / static_cast<double>(points));
        laps[who].points_per_round = points;
        laps[who].checked = laps[who].checked && rivals[who].check();
        round_seconds += seconds;
      }
      state.SetIterationTime(round_seconds);
      ++round;
      if (options.stop != nullptr && options.stop()) {
        state.SkipWithError("stopped");
        break;
      }
    }
  };
  benchmark::ClearRegisteredBenchmarks();
  benchmark::RegisterBenchmark(name.c_str(), body)
      ->UseManualTime()
      ->Iterations(static_cast<benchmark::IterationCount>(options.rounds))
      ->Repetitions(1);
  SilentReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::ClearRegisteredBenchmarks();
  return laps;
}

}  // namespace bezierbench::timing
