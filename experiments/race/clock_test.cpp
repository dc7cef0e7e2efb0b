// SPDX-License-Identifier: MIT
#include "experiments/race/clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/failure.hpp"
#include "experiments/race/race.hpp"

namespace bezierbench::race {
namespace {

using testing::HasSubstr;

// Clocks have no state but their readings; each is a function of how often it, or the true clock, was read.
std::int64_t readings = 0;

std::int64_t standing() { return 42; }
std::int64_t backward() { return -++readings; }
std::int64_t by_milliseconds() { return steady_ns() / 4'000'000 * 4'000'000; }
std::int64_t steady_by(std::int64_t step) { return step * ++readings; }

class Clocks : public testing::Test {
 protected:
  void SetUp() override { readings = 0; }

  static void expect_refused(Clock clock, const char* why) {
    const Rival rival{"one", 1, [] {}, [] { return true; }};
    const std::vector<Rival> rivals{rival, rival};
    try {
      race("test", rivals, {.rounds = 2000, .least_rounds = 2000, .clock = clock});
      FAIL() << "not refused";
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.exit(), Exit::environment);
      EXPECT_THAT(failure.what(), HasSubstr(why));
    }
  }
};

TEST_F(Clocks, OfThisMachineIsFit) { EXPECT_EQ(clock_fault(steady_ns), std::nullopt); }

TEST_F(Clocks, ThatStandStillAreRefused) { expect_refused(standing, "clock: stands still"); }
TEST_F(Clocks, ThatGoBackAreRefused) { expect_refused(backward, "clock: goes back"); }
TEST_F(Clocks, ThatStepByMoreThanAShareOfATurnAreRefused) { expect_refused(by_milliseconds, "clock: steps by "); }
TEST_F(Clocks, MayStepByAHundredthOfATurn) {
  EXPECT_EQ(clock_fault([] { return steady_by(500); }), std::nullopt);
  EXPECT_THAT(clock_fault([] { return steady_by(501); }).value_or(""),
              HasSubstr("501 ns, more than 1 % of the 50000 ns"));
  EXPECT_EQ(clock_fault([] { return steady_by(501); }, 1e-4), std::nullopt);
}

// What is timed is what the clock says, and nothing else.
TEST_F(Clocks, DecideTheTimes) {
  const std::vector<Rival> rivals{{"one", 1, [] { readings += 60'000; }, [] { return true; }}};
  const auto laps = race("test", rivals, {.rounds = 4, .clock = [] { return ++readings; }});
  ASSERT_EQ(laps[0].ns_per_point.size(), 4U);
  for (const double ns : laps[0].ns_per_point) EXPECT_EQ(ns, 60'001);
}

}  // namespace
}  // namespace bezierbench::race
