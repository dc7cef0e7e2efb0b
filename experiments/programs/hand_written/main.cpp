// SPDX-License-Identifier: MIT
// Times every evaluator, one point at a time, against the same operations written by hand for one degree: both in one
// race, both behind a function pointer, with the same bits in every round. Exit 1 where an evaluator takes more than
// 1.15 times the time of the hand-written coding, by the whole interval of the ratio, or where their bits differ. A cell
// that takes longer is raced once more at the end, since a disturbance may outlast a race; the second race counts.
// bezierbench_hand_written [ID...]: races the evaluators with these ids, which may contain * and ?. Without an id it
// races all evaluators.
#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/programs/hand_written/cells.hpp"
#include "experiments/programs/one_curve.hpp"
#include "experiments/race/kernel_rival.hpp"
#include "experiments/race/repetition.hpp"
#include "experiments/race/stack_offset.hpp"
#include "experiments/suite/pattern.hpp"

namespace {

using namespace bezierbench;
using programs::Cell;
using programs::Cells;

constexpr double most_ratio = 1.15;
constexpr std::size_t points_of_batch = 256;

enum class Outcome { met, missed, other_bits };

constexpr std::string_view name(Outcome outcome) {
  return outcome == Outcome::met ? "met" : outcome == Outcome::missed ? "MISSED" : "OTHER BITS";
}

/// Races the evaluator of a cell against its hand-written coding and prints a line.
template <class Scalar>
Outcome race_of(const Cell<Scalar>& cell) {
  const auto inputs =
      programs::one_curve<Scalar>(cell.ours->info->form, cell.ours->dimension, cell.degree, points_of_batch);
  const auto judged = programs::points_of(*cell.ours, inputs);
  std::vector<double> ratios;
  std::vector<double> times;
  bool same_bits = true;
  for (std::size_t repetition = 0; repetition < race::repetitions_per_race; ++repetition) {
    const std::vector<race::Rival> rivals{race::kernel_rival(cell.by_hand, suite::Mode::point, inputs, judged),
                                          race::kernel_rival(*cell.ours, suite::Mode::point, inputs, judged)};
    const auto laps = race::with_stack_moved(
        repetition, [&] { return race::race("hand_written", rivals, race::options_of_a_repetition()); });
    ratios.push_back(race::median_ratio(laps[1], laps[0]));
    times.push_back(race::median_ns(laps[1]));
    same_bits = same_bits && laps[0].checked && laps[1].checked;
  }
  const auto interval = metric::median_interval(ratios, metric::timing_confidence);
  const auto outcome = !same_bits ? Outcome::other_bits : interval.low <= most_ratio ? Outcome::met : Outcome::missed;
  fmt::print("{:<27} {:<19} {:<6} {} {:>3} {:>8.2f} ns {:>6.2f} [{:.2f}, {:.2f}]  {}\n", cell.evaluator->id,
             name(cell.evaluator->form), std::is_same_v<Scalar, double> ? "double" : "float", cell.ours->dimension,
             cell.degree, metric::median(times), interval.median, interval.low, interval.high, name(outcome));
  return outcome;
}

template <class Scalar>
Cells<Scalar> all_cells() {
  Cells<Scalar> cells;
  programs::append_cells<Scalar, instantiate::Family::triangle>(cells);
  programs::append_cells<Scalar, instantiate::Family::bernstein>(cells);
  programs::append_cells<Scalar, instantiate::Family::power>(cells);
  programs::append_cells<Scalar, instantiate::Family::rational>(cells);
  return cells;
}

bool is_named(const MethodInfo& evaluator, std::span<const char* const> patterns) {
  return patterns.empty() ||
         std::ranges::any_of(patterns, [&](const char* pattern) { return suite::matches(pattern, evaluator.id); });
}

struct Counts {
  int cells = 0;
  int missed = 0;
};

template <class Scalar>
Counts race_all(const Cells<Scalar>& cells, std::span<const char* const> patterns) {
  Counts counts;
  std::vector<const Cell<Scalar>*> again;
  for (const auto& cell : cells.coded) {
    if (!is_named(*cell.evaluator, patterns)) continue;
    ++counts.cells;
    if (race_of(cell) != Outcome::met) again.push_back(&cell);
  }
  if (!again.empty()) fmt::print("once more:\n");
  for (const auto* cell : again)
    if (race_of(*cell) != Outcome::met) ++counts.missed;
  return counts;
}

void print_without_coding(std::span<const MethodInfo* const> evaluators, std::span<const char* const> patterns) {
  for (const auto* evaluator : evaluators)
    if (is_named(*evaluator, patterns))
      fmt::print("no hand-written coding: {} ({})\n", evaluator->id, name(evaluator->form));
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<const char* const> patterns(argv + 1, static_cast<std::size_t>(argc) - 1);
  fmt::print("{:<27} {:<19} {:<6} d {:>3} {:>11} {:>6} {}\n", "evaluator", "form", "scalar", "n", "ours", "ratio",
             "to the hand-written coding");
  const auto doubles = all_cells<double>();
  const auto of_double = race_all(doubles, patterns);
  const auto of_float = race_all(all_cells<float>(), patterns);
  print_without_coding(doubles.without_coding, patterns);
  fmt::print("{} cells, {} missed\n", of_double.cells + of_float.cells, of_double.missed + of_float.missed);
  return of_double.missed + of_float.missed == 0 ? 0 : 1;
}
