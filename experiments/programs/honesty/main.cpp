// SPDX-License-Identifier: MIT
// Checks the timing harness on races with a known result: a kernel against itself, whose verdict must be `same`, and
// against itself with 34 batches counted as 33, whose verdict must be `slower`. Prints the counts of verdicts.
#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/programs/one_curve.hpp"
#include "experiments/race/kernel_rival.hpp"
#include "experiments/race/race.hpp"
#include "experiments/race/rounds.hpp"
#include "experiments/suite/suite.hpp"

namespace {

using namespace bezierbench;

constexpr int races = 100;
constexpr int min_verdicts = 95;
constexpr std::size_t batch_points = 16;  // so few that a round is short
constexpr std::size_t batches = 33;
constexpr std::size_t slower_batches = 34;

/// A rival that does the work of `count` batches and reports the time of `batches`: more of the same work on the same
/// memory.
race::Rival rival_of(const Kernel<double>& kernel, suite::Mode mode, const race::Inputs<double>& inputs,
                     std::size_t count) {
  auto rival = race::kernel_rival(kernel, mode, inputs, programs::points_of(kernel, inputs));
  rival.points_per_batch = batch_points * batches;
  rival.run = [run = std::move(rival.run), count] {
    for (std::size_t k = 0; k < count; ++k) run();
  };
  return rival;
}

/// The verdict on `count` batches against `batches`, as a row of timing.csv would say it.
metric::Verdict verdict_of(const Kernel<double>& kernel, suite::Mode mode, const race::Inputs<double>& inputs,
                           std::size_t count) {
  std::vector<double> ratios;
  for (std::size_t repetition = 0; repetition < race::repetitions_per_race; ++repetition) {
    std::vector<race::Rival> rivals{rival_of(kernel, mode, inputs, batches), rival_of(kernel, mode, inputs, count)};
    std::ranges::copy(race::sentinels(), std::back_inserter(rivals));
    const auto times = race::with_stack_moved(
        repetition, [&] { return race::time_rounds("honesty", rivals, race::repetition_options()); });
    ratios.push_back(race::median_ratio(times[1], times[0]));
  }
  return metric::verdict(metric::median_interval(ratios, metric::timing_confidence));
}

/// Runs 100 races, prints the counts of verdicts, and returns how often `expected` occurred.
int count_of(std::string_view contest, suite::Mode mode, std::size_t count, metric::Verdict expected) {
  const auto& kernel = *find_kernel<double>("de_casteljau", Form::bernstein, 2);
  const auto inputs = programs::one_curve<double>(Form::bernstein, 2, 10, batch_points);
  std::map<metric::Verdict, int> verdicts;
  for (int race = 0; race < races; ++race) ++verdicts[verdict_of(kernel, mode, inputs, count)];
  fmt::print("{:<16} {:<6}", contest, suite::name(mode));
  for (const auto verdict :
       {metric::Verdict::same, metric::Verdict::slower, metric::Verdict::faster, metric::Verdict::unresolved})
    fmt::print("  {} {:>3}", metric::name(verdict), verdicts[verdict]);
  fmt::print("   {} {} at least: {}\n", metric::name(expected), min_verdicts,
             verdicts[expected] >= min_verdicts ? "yes" : "NO");
  return verdicts[expected];
}

}  // namespace

int main() {
  bool honest = true;
  for (const auto mode : {suite::Mode::point, suite::Mode::batch}) {
    honest = count_of("against itself", mode, batches, metric::Verdict::same) >= min_verdicts && honest;
    honest = count_of("3 % more work", mode, slower_batches, metric::Verdict::slower) >= min_verdicts && honest;
  }
  return honest ? 0 : 1;
}
