// SPDX-License-Identifier: MIT
// Whether intervals over repetitions hold the true ratio as often as they say, on races that are made up.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/race/race.hpp"
#include "experiments/sample/words.hpp"

namespace bezierbench::race {
namespace {

constexpr double true_ratio = 1.25;
constexpr std::size_t rounds = 33;
constexpr double spread_of_rounds = 0.01;

/// Uniform in (0, 1): a function of what it is drawn for.
double uniform(std::uint64_t race, std::uint64_t repetition, std::uint64_t round, std::uint64_t what) {
  return (static_cast<double>(sample::philox({race, repetition, round, what}, {1, 0})[0] >> 11U) + 0.5) * 0x1p-53;
}

/// By Box and Muller.
double normal(std::uint64_t race, std::uint64_t repetition, std::uint64_t round) {
  return std::sqrt(-2 * std::log(uniform(race, repetition, round, 0))) *
         std::cos(2 * std::numbers::pi * uniform(race, repetition, round, 1));
}

/// How far the logarithm of a repetition's ratio is from that of the true one, which is the median over repetitions.
using Effect = double (*)(std::uint64_t race, std::uint64_t repetition);
constexpr std::uint64_t whole_repetition = ~std::uint64_t{0};

double normal_effect(std::uint64_t race, std::uint64_t repetition) {
  return 0.02 * normal(race, repetition, whole_repetition);
}
/// Skewed: most repetitions are nearly alike and some far slower.
double exponential_effect(std::uint64_t race, std::uint64_t repetition) {
  return 0.02 * (-std::log(uniform(race, repetition, whole_repetition, 0)) - std::numbers::ln2);
}
double no_effect(std::uint64_t /*race*/, std::uint64_t /*repetition*/) { return 0; }

struct SimulatedRace {
  std::vector<RoundTimes> repetitions;
  std::vector<RoundTimes> base;
};

/// The base takes 10 ns in a machine whose speed changes from round to round.
SimulatedRace simulated(std::uint64_t race, Effect effect) {
  SimulatedRace result{std::vector<RoundTimes>(repetitions_per_race), std::vector<RoundTimes>(repetitions_per_race)};
  for (std::uint64_t repetition = 0; repetition < repetitions_per_race; ++repetition)
    for (std::uint64_t round = 0; round < rounds; ++round) {
      const double machine = 10 * (1 + uniform(race, repetition, round, 2));
      const double log_ratio = effect(race, repetition) + spread_of_rounds * normal(race, repetition, round);
      result.base[repetition].ns_per_point.push_back(machine);
      result.repetitions[repetition].ns_per_point.push_back(machine * true_ratio * std::exp(log_ratio));
    }
  return result;
}

struct Coverage {
  double over_repetitions = 0;
  double over_rounds = 0;  ///< of an interval that takes all rounds as independent
};

bool holds(const std::vector<double>& ratios) {
  const auto interval = metric::median_interval(ratios, metric::timing_confidence);
  return interval.low <= true_ratio && true_ratio <= interval.high;
}

Coverage coverage(Effect effect) {
  constexpr int races = 2000;
  constexpr int pooled_races = 400;  // enough to see how wrong they are
  Coverage counts;
  for (int race = 0; race < races; ++race) {
    const auto one = simulated(static_cast<std::uint64_t>(race), effect);
    counts.over_repetitions += holds(repetition_ratios(one.repetitions, one.base)) ? 1 : 0;
    if (race >= pooled_races) continue;
    std::vector<double> pooled;
    for (std::size_t k = 0; k < repetitions_per_race; ++k)
      for (std::size_t round = 0; round < rounds; ++round)
        pooled.push_back(one.repetitions[k].ns_per_point[round] / one.base[k].ns_per_point[round]);
    counts.over_rounds += holds(pooled) ? 1 : 0;
  }
  return {counts.over_repetitions / races, counts.over_rounds / pooled_races};
}

TEST(Repetitions, IntervalsHoldTheTrueRatioWhereRepetitionsDiffer) {
  for (const auto effect : {normal_effect, exponential_effect}) {
    const auto found = coverage(effect);
    EXPECT_GE(found.over_repetitions, 0.985);
    EXPECT_LT(found.over_repetitions, 1) << "and not simply everything";
    EXPECT_LT(found.over_rounds, 0.9) << "or else the test could not tell the two apart";
  }
}

TEST(Repetitions, IntervalsHoldTheTrueRatioWhereRepetitionsAreAlike) {
  const auto found = coverage(no_effect);
  EXPECT_GE(found.over_repetitions, 0.985);
  EXPECT_GE(found.over_rounds, 0.985);
}

// One disturbed repetition moves neither end of an interval.
TEST(Repetitions, ADisturbedOneMovesNoInterval) {
  std::vector<double> ratios(repetitions_per_race, 1);
  ratios[3] = 2;
  EXPECT_EQ(metric::median_interval(ratios, metric::timing_confidence).high, 1);
  ratios.pop_back();
  EXPECT_EQ(metric::median_interval(ratios, metric::timing_confidence).high, 2) << "fewer would not do";
}

TEST(Repetitions, ShareWhatARaceMayTake) {
  const RaceOptions whole;
  const auto each = repetition_options();
  EXPECT_GE(each.min_rounds * repetitions_per_race, whole.min_rounds);
  EXPECT_LE(each.rounds * repetitions_per_race, whole.rounds);
  EXPECT_DOUBLE_EQ(each.rival_seconds * static_cast<double>(repetitions_per_race), whole.rival_seconds);
}

}  // namespace
}  // namespace bezierbench::race
