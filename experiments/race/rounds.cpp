// SPDX-License-Identifier: MIT
#include "experiments/race/rounds.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace bezierbench::race {
namespace {

constexpr double ns_per_second = 1e9;

/// Runs a copy of the rival's function. The copy has the same place on the stack for every rival, and it allocates from
/// the memory that the last copy freed (PageVector says why places matter).
double seconds_of(const Rival& rival, std::size_t batches, Clock clock) {
  const auto run = rival.run;
  const std::int64_t start = clock();
  for (std::size_t k = 0; k < batches; ++k) {
    run();
    benchmark::ClobberMemory();  // the compiler must assume that the results are read
  }
  return static_cast<double>(clock() - start) / ns_per_second;
}

/// The number of batches with which one rival takes `min_seconds`. Of three tries the fastest counts, so that a
/// preemption does not end the search. The number is not rounded to a power of two, so that rivals of equal speed get
/// equal numbers. The doubling also warms the rival up.
std::size_t batches_per_round(const Rival& rival, double min_seconds, Clock clock) {
  const auto fastest_of_three = [&](std::size_t batches) {
    return std::min(
        {seconds_of(rival, batches, clock), seconds_of(rival, batches, clock), seconds_of(rival, batches, clock)});
  };
  std::size_t batches = 1;
  double seconds = fastest_of_three(batches);
  while (seconds < min_seconds) {
    batches *= 2;
    seconds = fastest_of_three(batches);
  }
  return static_cast<std::size_t>(std::ceil(static_cast<double>(batches) * min_seconds / seconds));
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

/// Runs one rival in one round: an untimed batch to load its code and data into the caches, then the timed batches. The
/// counters are read outside the timed part. Returns the seconds of the timed batches.
double run_round(const Rival& rival, std::size_t batches, const RaceOptions& options, RoundTimes& times) {
  const Counters* counters = options.counters;
  rival.run();
  const auto before = counters != nullptr ? counters->read() : std::nullopt;
  const double seconds = seconds_of(rival, batches, options.clock);
  const auto after = before ? counters->read() : std::nullopt;
  const auto points = static_cast<double>(times.points_per_round);
  times.ns_per_point.push_back(seconds * ns_per_second / points);
  if (const auto counts = after ? counts_between(*before, *after) : std::nullopt) {
    times.cycles_per_point.push_back(counts->cycles / points);
    times.instructions_per_point.push_back(counts->instructions / points);
  }
  times.checked = rival.check() && times.checked;
  return seconds;
}

/// Google Benchmark prints nothing.
class SilentReporter final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& /*runs*/) override {}
};

constexpr std::size_t steps_per_batch = 1024;  // even: x is where it began
constexpr double start = 0.25;
constexpr std::size_t numbers_of_sweep = 256;  // two kilobytes, as the parameters of methods
constexpr std::size_t sweeps_per_batch = 16;   // even

/// Not a constant for the compiler, which would otherwise remove the product.
double one() {
  volatile double hidden = 1;
  return hidden;
}

}  // namespace

std::int64_t steady_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

void RoundTimes::append(const RoundTimes& other) {
  const auto add = [](std::vector<double>& all, const std::vector<double>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  add(ns_per_point, other.ns_per_point);
  add(cycles_per_point, other.cycles_per_point);
  add(instructions_per_point, other.instructions_per_point);
  points_per_round = std::max(points_per_round, other.points_per_round);
  checked = checked && other.checked;
}

std::vector<RoundTimes> time_rounds(const std::string& name, std::span<const Rival> rivals,
                                    const RaceOptions& options) {
  std::vector<RoundTimes> times(rivals.size());
  std::vector<std::size_t> batches;
  for (std::size_t who = 0; who < rivals.size(); ++who) {
    batches.push_back(batches_per_round(rivals[who], options.round_seconds, options.clock));
    times[who].points_per_round = batches[who] * rivals[who].points_per_batch;
  }

  const auto orders = counterbalanced_orders(rivals.size());
  const auto whole_cycles = [&](std::size_t rounds) {
    return (rounds + orders.size() - 1) / orders.size() * orders.size();
  };
  const double enough_seconds = options.rival_seconds * static_cast<double>(rivals.size());

  const auto body = [&](benchmark::State& state) {
    std::size_t round = 0;
    double total_seconds = 0;
    for ([[maybe_unused]] auto iteration : state) {
      double round_seconds = 0;
      for (const std::size_t who : orders[round % orders.size()])
        round_seconds += run_round(rivals[who], batches[who], options, times[who]);
      state.SetIterationTime(round_seconds);
      total_seconds += round_seconds;
      ++round;
      const bool enough = total_seconds >= enough_seconds && round >= options.min_rounds && round % orders.size() == 0;
      if (enough || total_seconds >= options.max_seconds || (options.stop != nullptr && options.stop())) {
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
  return times;
}

Rival chain_sentinel() {
  auto x = std::make_shared<double>(0);
  const auto run = [x] {
    const double factor = one();
    double value = start;
    for (std::size_t k = 0; k < steps_per_batch; ++k) value = factor - factor * value;
    *x = value;
  };
  return {std::string(sentinel_name), steps_per_batch, run, [x] { return std::exchange(*x, 0) == start; }};
}

Rival sweep_sentinel() {
  auto numbers = std::make_shared<PageVector<double, 0>>(numbers_of_sweep, 0);
  const auto run = [numbers] {
    std::ranges::fill(*numbers, start);
    const double factor = one();
    for (std::size_t sweep = 0; sweep < sweeps_per_batch; ++sweep)
      for (double& x : *numbers) x = factor - factor * x;
  };
  const auto check = [numbers] {
    const bool right = std::ranges::all_of(*numbers, [](double x) { return x == start; });
    std::ranges::fill(*numbers, 0);
    return right;
  };
  return {"sweep", numbers_of_sweep * sweeps_per_batch, run, check};
}

std::array<Rival, 2> sentinels() { return {sweep_sentinel(), chain_sentinel()}; }

}  // namespace bezierbench::race
