// SPDX-License-Identifier: MIT
#include "experiments/race/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

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
}  // namespace bezierbench::race
