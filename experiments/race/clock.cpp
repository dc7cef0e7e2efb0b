// SPDX-License-Identifier: MIT
#include "experiments/race/clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "experiments/failure.hpp"

namespace bezierbench::race {

std::int64_t steady_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::optional<std::string> clock_fault(Clock clock, double turn_seconds) {
  constexpr int enough_steps = 200;
  constexpr int most_readings = 1'000'000;
  constexpr double ns_per_second = 1e9;
  constexpr double percent = 100;
  std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
  std::int64_t last = clock();
  int steps = 0;
  for (int reading = 0; reading < most_readings && steps < enough_steps; ++reading) {
    const std::int64_t now = clock();
    if (now < last) return fmt::format("goes back, by {} ns between two readings", last - now);
    if (now == last) continue;
    smallest = std::min(smallest, now - last);
    last = now;
    ++steps;
  }
  if (steps == 0) return fmt::format("stands still, for {} readings", most_readings);
  const double turn_ns = turn_seconds * ns_per_second;
  if (static_cast<double>(smallest) > largest_step_share * turn_ns)
    return fmt::format("steps by {} ns, more than {:g} % of the {:g} ns that a turn of a race takes", smallest,
                       percent * largest_step_share, turn_ns);
  return std::nullopt;
}

void refuse_clock(const std::string& fault) {
  throw Failure(
      Exit::environment,
      fmt::format("clock: {}; times cannot be taken here, run with --no-timing or on another machine", fault));
}

void require_steady_clock() {
  if (const auto fault = clock_fault(steady_ns)) refuse_clock(*fault);
}

}  // namespace bezierbench::race
