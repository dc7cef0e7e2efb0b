// SPDX-License-Identifier: MIT
#include "experiments/race/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/race/race.hpp"
#include "experiments/sample/words.hpp"

namespace bezierbench::race {

namespace {

TEST(Rounds, EveryRivalRunsEveryRoundAndIsChecked) {
  int runs = 0;
  int checks = 0;
  const std::vector<Rival> rivals{
      {"good", 3, [&] { ++runs; }, [&] { return ++checks > 0; }},
      {"wrong", 3, [] {}, [] { return false; }},
  };
  const auto times = time_rounds("test", rivals, {.rounds = 10});
  ASSERT_EQ(times.size(), 2U);
  EXPECT_EQ(times[0].ns_per_point.size(), 10U);
  EXPECT_EQ(times[1].ns_per_point.size(), 10U);
  EXPECT_EQ(times[0].points_per_round % 3, 0U);
  EXPECT_EQ(checks, 10);
  EXPECT_GE(runs, 10);
  EXPECT_TRUE(times[0].checked);
  EXPECT_FALSE(times[1].checked);
  EXPECT_TRUE(std::ranges::all_of(times[0].ns_per_point, [](double ns) { return ns >= 0; }));
}

TEST(Rounds, EveryRivalMeetsEveryPlaceAndEveryPredecessorEquallyOften) {
  for (const std::size_t count : {2U, 3U, 4U, 5U}) {
    std::string order;
    std::vector<Rival> rivals;
    for (std::size_t k = 0; k < count; ++k) {
      const char name = static_cast<char>('a' + k);
      rivals.push_back({std::string(1, name), 1, [] {},
                        [&order, name] {
                          order += name;
                          return true;
                        }});
    }
    time_rounds("test", rivals, {.rounds = 1});
    const std::size_t full_turns = order.size() / count;
    EXPECT_EQ(full_turns, count % 2 == 0 ? count : 2 * count);
    std::map<std::pair<char, std::size_t>, std::size_t> places;
    std::map<std::pair<char, char>, std::size_t> neighbours;
    for (std::size_t k = 0; k < order.size(); ++k) {
      ++places[{order[k], k % count}];
      if (k % count > 0) ++neighbours[{order[k - 1], order[k]}];
    }
    EXPECT_EQ(places.size(), count * count);
    EXPECT_EQ(neighbours.size(), count * (count - 1));
    for (const auto& [place, times] : places) EXPECT_EQ(times, full_turns / count) << order;
    for (const auto& [pair, times] : neighbours) EXPECT_EQ(times, full_turns / count) << order;
  }
}

/// Notes where it lies when it runs.
struct Placed {
  std::set<const void*>* places;
  void operator()() const { places->insert(this); }
};

// What lies elsewhere for one of two equal rivals may make it the slower.
TEST(Rounds, RunsEveryRivalAtOnePlace) {
  std::vector<std::set<const void*>> places(3);
  std::vector<Rival> rivals;
  for (auto& its : places) rivals.push_back({"one", 1, Placed{&its}, [] { return true; }});
  time_rounds("test", rivals, {.rounds = 6});
  std::set<const void*> common = places[0];
  for (const auto& its : places) std::erase_if(common, [&](const void* place) { return !its.contains(place); });
  EXPECT_FALSE(common.empty());
}

TEST(Rounds, StopsOnRequest) {
  const std::vector<Rival> rivals{{"one", 1, [] {}, [] { return true; }}};
  const auto times = time_rounds("test", rivals, {.rounds = 1000, .stop = [] { return true; }});
  EXPECT_EQ(times[0].ns_per_point.size(), 1U);
}

TEST(Rounds, EndsWhenItsTimeIsUp) {
  const std::vector<Rival> rivals{{"one", 1, [] {}, [] { return true; }}};
  const auto times = time_rounds("test", rivals, {.rounds = 1000, .max_seconds = 0});
  EXPECT_EQ(times[0].ns_per_point.size(), 1U);
}

TEST(Rounds, SlowRivalsRunFewerRoundsButWholeCycles) {
  const Rival rival{"one", 1, [] {}, [] { return true; }};
  const std::vector<Rival> three(3, rival);  // six orders
  const auto times = time_rounds("test", three, {.rounds = 1000, .min_rounds = 7, .rival_seconds = 0});
  EXPECT_EQ(times[0].ns_per_point.size(), 12U);
}

/// In every round a rival runs one batch that is not timed before those that are.
TEST(Rounds, WarmUpEveryRival) {
  int runs = 0;
  int at_last_check = 0;
  std::vector<int> runs_per_round;
  const std::vector<Rival> rivals{{"one", 1, [&] { ++runs; },
                                   [&] {
                                     runs_per_round.push_back(runs - at_last_check);
                                     at_last_check = runs;
                                     return true;
                                   }}};
  const auto times = time_rounds("test", rivals, {.rounds = 4});
  ASSERT_EQ(runs_per_round.size(), 4U);
  for (std::size_t round = 1; round < 4; ++round)
    EXPECT_EQ(static_cast<std::size_t>(runs_per_round[round]), times[0].points_per_round + 1);
}

TEST(Rounds, CountsPerPointWhereThereAreCounters) {
  const Counters counters;
  const std::vector<Rival> rivals{{"one", 1, [] {}, [] { return true; }}};
  const auto times = time_rounds("test", rivals, {.rounds = 10, .counters = &counters});
  EXPECT_EQ(times[0].cycles_per_point.size(), times[0].instructions_per_point.size());
  EXPECT_LE(times[0].cycles_per_point.size(), counters.available() ? 10U : 0U);
}

/// A clock that advances by 60 microseconds in every batch and by a nanosecond with every reading.
TEST(Rounds, AreTimedByTheClockOfTheOptions) {
  static std::int64_t now = 0;
  const std::vector<Rival> rivals{{"one", 1, [] { now += 60'000; }, [] { return true; }}};
  const auto times = time_rounds("test", rivals, {.rounds = 4, .clock = [] { return ++now; }});
  EXPECT_EQ(times[0].ns_per_point, std::vector<double>(4, 60'001));
}

TEST(Sentinels, KnowTheirResults) {
  for (const Rival& rival : sentinels()) {
    EXPECT_FALSE(rival.check()) << "nothing ran yet";
    rival.run();
    EXPECT_TRUE(rival.check());
    EXPECT_FALSE(rival.check()) << "a check uses the result up";
  }
  EXPECT_EQ(sentinels().back().name, sentinel_name);
}

}  // namespace

// Whether intervals over repetitions hold the true ratio as often as they say, on races that are made up.

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
