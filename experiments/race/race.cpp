// SPDX-License-Identifier: MIT
#include "experiments/race/race.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bezierbench::race {
namespace {

constexpr double ns_per_second = 1e9;

/// Runs a copy of the rival's function. The copy has the same place on the stack for every rival, and it allocates from
/// the memory that the last copy freed (page_vector.hpp says why places matter).
double seconds_of(const Rival& rival, std::size_t repetitions, Clock clock) {
  const auto run = rival.run;
  const std::int64_t start = clock();
  for (std::size_t k = 0; k < repetitions; ++k) {
    run();
    benchmark::ClobberMemory();  // the compiler must assume that the results are read
  }
  return static_cast<double>(clock() - start) / ns_per_second;
}

/// The number of batches with which one rival's turn takes `least_seconds`. Of three tries the fastest counts, so that
/// a preemption does not end the search. The number is not rounded to a power of two, so that rivals of equal speed get
/// equal turns. The doubling also warms the rival up. A clock that hardly moves during `many` batches is refused, since
/// the search would not end.
std::size_t calibrated_repetitions(const Rival& rival, double least_seconds, Clock clock) {
  constexpr std::size_t many = 4096;            // calls that take longer than the largest step that a clock may have
  constexpr double least_call_seconds = 1e-11;  // a twentieth of a processor's cycle or less
  const auto fastest_of_three = [&](std::size_t repetitions) {
    const double seconds = std::min({seconds_of(rival, repetitions, clock), seconds_of(rival, repetitions, clock),
                                     seconds_of(rival, repetitions, clock)});
    if (seconds < 0) refuse_clock("goes back");
    if (repetitions >= many && seconds < least_call_seconds * static_cast<double>(repetitions))
      refuse_clock("stands still, or nearly");
    return seconds;
  };
  std::size_t repetitions = 1;
  double seconds = fastest_of_three(repetitions);
  while (seconds < least_seconds) {
    repetitions *= 2;
    seconds = fastest_of_three(repetitions);
  }
  return static_cast<std::size_t>(std::ceil(static_cast<double>(repetitions) * least_seconds / seconds));
}

/// Orders of the rivals, one per round: Williams' design, in which every rival has every position and directly follows
/// every other rival equally often. Source: Williams, Australian J. Sci. Res. A 2 (1949) 149-168.
std::vector<std::vector<std::size_t>> counterbalanced_orders(std::size_t rivals) {
  std::vector<std::vector<std::size_t>> orders;
  for (std::size_t shift = 0; shift < rivals; ++shift) {
    std::vector<std::size_t> order;  // 0, 1, R-1, 2, R-2, ... moved on by `shift`
    for (std::size_t place = 0; place < rivals; ++place) {
      const std::size_t step = place % 2 == 1 ? (place + 1) / 2 : rivals - place / 2;
      order.push_back((step + shift) % rivals);
    }
    orders.push_back(order);
    if (rivals % 2 != 0) orders.emplace_back(order.rbegin(), order.rend());  // an odd number needs the mirror images
  }
  return orders;
}

/// One rival's turn in one round: a batch to call its code and data back into the caches, then the batches that count.
/// The counters are read outside the clock.
double run_turn(const Rival& rival, std::size_t repetitions, const RaceOptions& options, Lap& lap) {
  const Counters* counters = options.counters;
  rival.run();
  const auto before = counters != nullptr ? counters->read() : std::nullopt;
  const double seconds = seconds_of(rival, repetitions, options.clock);
  const auto after = before ? counters->read() : std::nullopt;
  const auto points = static_cast<double>(lap.points_per_round);
  lap.ns_per_point.push_back(seconds * ns_per_second / points);
  if (const auto counts = after ? counts_between(*before, *after) : std::nullopt) {
    lap.cycles_per_point.push_back(counts->cycles / points);
    lap.instructions_per_point.push_back(counts->instructions / points);
  }
  lap.checked = rival.check() && lap.checked;
  return seconds;
}

/// Google Benchmark prints nothing: the laps are the result.
class SilentReporter final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& /*runs*/) override {}
};

}  // namespace

void Lap::append(const Lap& other) {
  const auto add = [](std::vector<double>& all, const std::vector<double>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  add(ns_per_point, other.ns_per_point);
  add(cycles_per_point, other.cycles_per_point);
  add(instructions_per_point, other.instructions_per_point);
  points_per_round = std::max(points_per_round, other.points_per_round);
  checked = checked && other.checked;
}

std::vector<Lap> race(const std::string& name, std::span<const Rival> rivals, const RaceOptions& options) {
  if (const auto fault = clock_fault(options.clock, options.round_seconds)) refuse_clock(*fault);
  std::vector<Lap> laps(rivals.size());
  std::vector<std::size_t> repetitions;
  for (std::size_t who = 0; who < rivals.size(); ++who) {
    repetitions.push_back(calibrated_repetitions(rivals[who], options.round_seconds, options.clock));
    laps[who].points_per_round = repetitions[who] * rivals[who].points_per_batch;
  }

  const auto orders = counterbalanced_orders(rivals.size());
  const auto whole_cycles = [&](std::size_t rounds) {
    return (rounds + orders.size() - 1) / orders.size() * orders.size();
  };
  const double enough_seconds = options.rival_seconds * static_cast<double>(rivals.size());

  bool clock_stopped = false;  // reported after Google Benchmark has returned, which does not expect exceptions
  const auto body = [&](benchmark::State& state) {
    std::size_t round = 0;
    double total_seconds = 0;
    for ([[maybe_unused]] auto iteration : state) {
      double round_seconds = 0;
      for (const std::size_t who : orders[round % orders.size()]) {
        const double seconds = run_turn(rivals[who], repetitions[who], options, laps[who]);
        clock_stopped = clock_stopped || seconds <= 0;
        round_seconds += seconds;
      }
      state.SetIterationTime(round_seconds);
      total_seconds += round_seconds;
      ++round;
      const bool enough =
          total_seconds >= enough_seconds && round >= options.least_rounds && round % orders.size() == 0;
      if (clock_stopped || enough || total_seconds >= options.most_seconds ||
          (options.stop != nullptr && options.stop())) {
        state.SkipWithError("stopped");
        break;
      }
    }
  };
  benchmark::ClearRegisteredBenchmarks();
  benchmark::RegisterBenchmark(name.c_str(), body)
      ->UseManualTime()
      ->Iterations(static_cast<benchmark::IterationCount>(whole_cycles(options.rounds)))
      ->Repetitions(1);
  SilentReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::ClearRegisteredBenchmarks();
  if (clock_stopped) refuse_clock("stood still or went back during a turn of a race");
  return laps;
}

}  // namespace bezierbench::race
