// SPDX-License-Identifier: MIT
// Times methods, one point at a time, against the same operations written by hand (codings.hpp): both in one race, both
// behind a function pointer, with the same bits in every round. Exit 1 where a method takes more than 1.15 times the time
// of the hand-written coding, by the whole interval of the ratio, or where their bits differ.
#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <new>
#include <span>
#include <vector>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/programs/hand_written/codings.hpp"
#include "experiments/programs/one_curve.hpp"
#include "experiments/race/kernel_rival.hpp"
#include "experiments/race/repetition.hpp"
#include "experiments/race/sentinel.hpp"
#include "experiments/race/stack_offset.hpp"

namespace {

using namespace bezierbench;

constexpr double most_ratio = 1.15;
constexpr std::size_t points_of_batch = 256;

/// A hand-written coding behind the interface of the methods.
template <template <int> class Coding, int Degree>
Kernel<double> kernel_of(const Kernel<double>& ours) {
  using Points = hand_written::Points<Degree>;
  Kernel<double> kernel = ours;
  kernel.prepared_size = sizeof(Points);
  kernel.prepared_alignment = alignof(Points);
  kernel.prepare = [](const CurveView<double>& curve, void* prepared) {
    auto& points = *new (prepared) Points;
    std::memcpy(points.data(), curve.coefficients.data(), sizeof(Points));
    Coding<Degree>::prepare(points);
  };
  kernel.evaluate = [](const void* prepared, std::span<const double> t, double* points) {
    const auto& state = *static_cast<const Points*>(prepared);
    for (const double at : t) {
      const hand_written::Pair point = Coding<Degree>::evaluate(state, at);
      std::memcpy(points, &point, sizeof(point));
      points += 2;
    }
  };
  return kernel;
}

/// Races a method against its hand-written coding, prints a line, and returns whether it is near enough.
template <template <int> class Coding, int Degree>
bool is_near(Form form) {
  const auto& ours = *find_kernel<double>(Coding<Degree>::id, form, 2);
  const auto by_hand = kernel_of<Coding, Degree>(ours);
  const auto inputs = programs::one_curve(form, Degree, points_of_batch);
  const auto judged = programs::points_of(ours, inputs);
  std::vector<double> ratios;
  std::vector<double> times;
  bool same_bits = true;
  for (std::size_t repetition = 0; repetition < race::repetitions_per_race; ++repetition) {
    std::vector<race::Rival> rivals{race::kernel_rival(by_hand, suite::Mode::point, inputs, judged),
                                    race::kernel_rival(ours, suite::Mode::point, inputs, judged)};
    std::ranges::copy(race::sentinels(), std::back_inserter(rivals));
    const auto laps = race::with_stack_moved(
        repetition, [&] { return race::race("hand_written", rivals, race::options_of_a_repetition()); });
    ratios.push_back(race::median_ratio(laps[1], laps[0]));
    times.push_back(metric::median(laps[1].ns_per_point));
    same_bits = same_bits && laps[0].checked && laps[1].checked;
  }
  const auto interval = metric::median_interval(ratios, metric::timing_confidence);
  const bool near = same_bits && interval.low <= most_ratio;
  fmt::print("{:<24} {:>3} {:>8.2f} ns {:>7.2f} [{:.2f}, {:.2f}]  {}\n", Coding<Degree>::id, Degree,
             metric::median(times), interval.median, interval.low, interval.high,
             !same_bits ? "OTHER BITS"
             : near     ? "met"
                        : "MISSED");
  return near;
}

template <template <int> class Coding>
bool are_near(Form form) {
  const bool near[] = {is_near<Coding, 3>(form), is_near<Coding, 5>(form), is_near<Coding, 10>(form),
                       is_near<Coding, 20>(form)};
  return std::ranges::all_of(near, [](bool one) { return one; });
}

}  // namespace

int main() {
  fmt::print("{:<24} {:>3} {:>11} {:>7} {}\n", "method", "n", "ours", "ratio", "to the hand-written coding");
  const bool near[] = {
      are_near<hand_written::DeCasteljau>(Form::bernstein), are_near<hand_written::DeCasteljauLerpFma>(Form::bernstein),
      are_near<hand_written::WoznyChudy>(Form::bernstein), are_near<hand_written::HornerBernstein>(Form::bernstein),
      are_near<hand_written::Horner>(Form::power)};
  return std::ranges::all_of(near, [](bool one) { return one; }) ? 0 : 1;
}
