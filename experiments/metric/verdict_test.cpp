// SPDX-License-Identifier: MIT
#include "experiments/metric/verdict.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace bezierbench::metric {
namespace {

TEST(Verdict, FollowsTheInterval) {
  EXPECT_EQ(verdict({1, 0.99, 1.01}), Verdict::same);
  EXPECT_EQ(verdict({1, 0.9899, 1.01}), Verdict::unresolved);
  EXPECT_EQ(verdict({1, 0.99, 1.0101}), Verdict::unresolved);
  EXPECT_EQ(verdict({1.02, 1.01, 1.03}), Verdict::unresolved);
  EXPECT_EQ(verdict({1.02, 1.0101, 1.03}), Verdict::slower);
  EXPECT_EQ(verdict({0.98, 0.97, 0.99}), Verdict::unresolved);
  EXPECT_EQ(verdict({0.98, 0.97, 0.9899}), Verdict::faster);
  EXPECT_EQ(verdict({1, 0.5, 2}), Verdict::unresolved);
  EXPECT_EQ(verdict({1.2, 1.1, 1.3}, 0.5), Verdict::same);
}

TEST(Verdict, NotANumberIsUnresolved) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(verdict({nan, nan, nan}), Verdict::unresolved);
  EXPECT_EQ(verdict({1, nan, 1}), Verdict::unresolved);
  EXPECT_EQ(verdict({1, 1, nan}), Verdict::unresolved);
}

/// Rounds of a noisy machine: a common factor that wanders by 30 %, noise of each run by up to 1 %, and one run in
/// twenty that is interrupted and takes up to three times as long.
class NoisyRounds {
 public:
  double ratio(double truth) {
    const double machine = 1 + 0.3 * unit();
    return truth * machine * one_run() / (machine * one_run());
  }

 private:
  double unit() { return static_cast<double>(words_() >> 11U) * 0x1p-53; }
  double one_run() { return (1 + 0.01 * unit()) * (unit() < 0.05 ? 1 + 2 * unit() : 1); }

  std::mt19937_64 words_{1};
};

/// How often each verdict falls among 1000 races of 41 rounds.
std::map<Verdict, int> verdicts_of(double truth) {
  NoisyRounds rounds;
  std::map<Verdict, int> counts;
  for (int race = 0; race < 1000; ++race) {
    std::vector<double> ratios;
    for (int round = 0; round < 41; ++round) ratios.push_back(rounds.ratio(truth));
    ++counts[verdict(median_interval(ratios, timing_confidence))];
  }
  return counts;
}

/// A false `slower` or `faster` needs a 99 % interval that misses the truth by more than the margin.
TEST(Verdict, EqualTimesAreTheSame) {
  const auto counts = verdicts_of(1);
  EXPECT_GE(counts.at(Verdict::same), 950);
  EXPECT_EQ(counts.count(Verdict::slower) + counts.count(Verdict::faster), 0U);
}

TEST(Verdict, ThreePercentAreSeen) {
  auto slower = verdicts_of(1.03);
  EXPECT_GE(slower[Verdict::slower], 950);
  EXPECT_EQ(slower[Verdict::same] + slower[Verdict::faster], 0);
  auto faster = verdicts_of(1 / 1.03);
  EXPECT_GE(faster[Verdict::faster], 950);
  EXPECT_EQ(faster[Verdict::same] + faster[Verdict::slower], 0);
}

/// On the edge of the margin nothing is claimed but in the 1 % that the interval allows.
TEST(Verdict, TheEdgeOfTheMarginIsUnresolved) {
  auto counts = verdicts_of(1 + practical_margin);
  EXPECT_GE(counts[Verdict::unresolved], 980);
}

}  // namespace
}  // namespace bezierbench::metric
