// SPDX-License-Identifier: MIT
// Times one evaluator of each family, one point at a time, against the same operations written by hand for one degree:
// all in one race, each behind a function pointer, with the same bits in every round. Exit 1 where an evaluator takes
// more than 1.15 times the time of the fastest coding by hand, by the whole interval of the ratio, or where their bits
// differ. A cell that takes longer is raced once more, since a disturbance may outlast a race; the second race counts.
#include <fmt/core.h>

#include <algorithm>
#include <new>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "core/evaluate/kernel/prepared_state.hpp"
#include "core/evaluate/methods/compensated_horner.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"
#include "core/evaluate/methods/estrin.hpp"
#include "core/evaluate/methods/horner.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"
#include "core/evaluate/methods/horner_fma.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/programs/hand_written/codings.hpp"
#include "experiments/programs/one_curve.hpp"
#include "experiments/race/kernel_rival.hpp"
#include "experiments/race/race.hpp"

namespace {

using namespace bezierbench;

constexpr double max_ratio = 1.15;
constexpr std::size_t batch_points = 256;

/// The coefficients that a method prepared: the curve itself, or the only part of its state.
template <class State>
const auto& coefficients_of(const State& state) {
  if constexpr (requires { state.parts(); })
    return std::get<0>(state.parts());
  else
    return state;
}

/// The coding behind the interface of `ours`, whose prepared coefficients it takes.
template <class Evaluator, class Coding, class Scalar, int Dimension, int Degree>
Kernel<Scalar> coded_kernel(const Kernel<Scalar>& ours) {
  using Points = hand_written::Points<Scalar, Dimension, Degree>;
  Kernel<Scalar> kernel = ours;
  kernel.prepared_size = sizeof(Points);
  kernel.prepared_alignment = alignof(Points);
  kernel.prepare = [](const CurveView<Scalar>& curve, void* prepared) {
    const auto& own = *find_kernel<Scalar>(Evaluator::info.id, Evaluator::info.form, Dimension);
    const PreparedState<Scalar> state(own, curve);
    auto& points = *new (prepared) Points;
    const auto& coefficients =
        coefficients_of(*static_cast<const PreparedOf<Evaluator, Scalar, Dimension>*>(state.get()));
    std::copy_n(coefficients.data(), points.values.size(), points.values.data());
  };
  kernel.evaluate_for = [](int /*degree*/) -> EvaluatePoints<Scalar> {
    return [](const void* prepared, std::span<const Scalar> t, Scalar* to) {
      const auto& points = *static_cast<const Points*>(prepared);
      for (const Scalar at : t) {
        hand_written::store<Dimension>(Coding::evaluate(at, points), to);
        to += Dimension;
      }
    };
  };
  return kernel;
}

struct Counts {
  int cells = 0;
  int missed = 0;
};

/// Races all codings and prints a line. Returns whether the goal is met.
template <class Scalar>
bool meets_goal(const Kernel<Scalar>& ours, const std::vector<Kernel<Scalar>>& by_hand, int degree) {
  const auto inputs = programs::one_curve<Scalar>(ours.info->form, ours.dimension, degree, batch_points);
  const auto judged = programs::points_of(ours, inputs);
  std::vector<std::vector<double>> ratios(by_hand.size());
  std::vector<double> times;
  bool same_bits = true;
  for (std::size_t repetition = 0; repetition < race::repetitions_per_race; ++repetition) {
    std::vector<race::Rival> rivals{race::kernel_rival(ours, suite::Mode::point, inputs, judged)};
    for (const auto& kernel : by_hand) rivals.push_back(race::kernel_rival(kernel, suite::Mode::point, inputs, judged));
    const auto rounds = race::with_stack_moved(
        repetition, [&] { return race::time_rounds("hand_written", rivals, race::repetition_options()); });
    for (std::size_t k = 0; k < by_hand.size(); ++k) ratios[k].push_back(race::median_ratio(rounds[0], rounds[k + 1]));
    times.push_back(race::median_ns(rounds[0]));
    for (const auto& round : rounds) same_bits = same_bits && round.checked;
  }
  // The fastest coding is the one to which ours has the largest ratio.
  const auto& to_fastest = *std::ranges::max_element(ratios, {}, [](const auto& all) { return metric::median(all); });
  const auto interval = metric::median_interval(to_fastest, metric::timing_confidence);
  const bool met = same_bits && interval.low <= max_ratio;
  fmt::print("{:<19} {:<6} {} {:>3} {:>8.2f} ns {:>6.2f} [{:.2f}, {:.2f}]  {}\n", ours.info->id,
             std::is_same_v<Scalar, double> ? "double" : "float", ours.dimension, degree, metric::median(times),
             interval.median, interval.low, interval.high,
             !same_bits ? "OTHER BITS"
             : met      ? "met"
                        : "MISSED");
  return met;
}

template <class Evaluator, class Scalar, int Dimension, int Degree, class... Codings>
void race_degree(Counts& counts) {
  const auto& ours = *find_kernel<Scalar>(Evaluator::info.id, Evaluator::info.form, Dimension);
  const std::vector<Kernel<Scalar>> by_hand{coded_kernel<Evaluator, Codings, Scalar, Dimension, Degree>(ours)...};
  ++counts.cells;
  if (!meets_goal(ours, by_hand, Degree) && !meets_goal(ours, by_hand, Degree)) ++counts.missed;
}

template <class Evaluator, class... Codings, class Scalar, int... Degree>
void race_degrees(Counts& counts, Scalar /*type*/, std::integer_sequence<int, Degree...> /*degrees*/) {
  (race_degree<Evaluator, Scalar, 1, Degree, Codings...>(counts), ...);
  (race_degree<Evaluator, Scalar, 2, Degree, Codings...>(counts), ...);
  (race_degree<Evaluator, Scalar, 3, Degree, Codings...>(counts), ...);
}

template <class Evaluator, class... Codings>
void race_evaluator(Counts& counts) {
  race_degrees<Evaluator, Codings...>(counts, 0.0, std::integer_sequence<int, 1, 2, 3, 5, 10, 13, 17, 21, 30, 48>());
  race_degrees<Evaluator, Codings...>(counts, 0.0F, std::integer_sequence<int, 3, 13, 21, 48>());
}

}  // namespace

int main() {
  fmt::print("{:<19} {:<6} d {:>3} {:>11} {:>6} {}\n", "evaluator", "scalar", "n", "ours", "ratio",
             "to the fastest by hand");
  Counts counts;
  using hand_written::Loop;
  using hand_written::WrittenOut;
  race_evaluator<HornerBernstein, hand_written::HornerBernstein<Loop>, hand_written::HornerBernstein<WrittenOut>>(
      counts);
  race_evaluator<DeCasteljau, hand_written::DeCasteljauLoop, hand_written::DeCasteljauWrittenOut>(counts);
  race_evaluator<Horner, hand_written::Horner<Loop>, hand_written::Horner<WrittenOut>>(counts);
  race_evaluator<HornerFma, hand_written::HornerFma<Loop>, hand_written::HornerFma<WrittenOut>>(counts);
  race_evaluator<Estrin, hand_written::Estrin>(counts);
  race_evaluator<CompensatedHorner, hand_written::CompensatedHorner>(counts);
  fmt::print("{} cells, {} missed\n", counts.cells, counts.missed);
  return counts.missed == 0 ? 0 : 1;
}
