// SPDX-License-Identifier: MIT
#include "experiments/compare/ratio.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "experiments/metric/verdict.hpp"

namespace bezierbench::compare {
namespace {

using metric::Interval;

constexpr double close = 1e-14;

void expect_close(const Interval& ours, const Interval& theirs) {
  EXPECT_NEAR(ours.median / theirs.median, 1, close);
  EXPECT_NEAR(ours.low / theirs.low, 1, close);
  EXPECT_NEAR(ours.high / theirs.high, 1, close);
}

Interval inverse(const Interval& x) { return {1 / x.median, 1 / x.high, 1 / x.low}; }

// With one time known exactly, the ratio's interval is the other's interval divided by it.
TEST(Ratio, OfAKnownTimeIsTheOthersInterval) {
  expect_close(ratio({6, 5, 8}, {2, 2, 2}), {3, 2.5, 4});
  expect_close(ratio({2, 2, 2}, {6, 5, 8}), {1.0 / 3, 0.25, 0.4});
}

// Limits that are factors of e^3 and e^4 away combine to a factor of e^5. The lower limit of b goes with the upper one
// of a.
TEST(Ratio, DistancesAddInSquares) {
  const double e = std::exp(1.0);
  const Interval b{7, 7 / std::pow(e, 3), 7 * std::pow(e, 5)};
  const Interval a{2, 2 / std::pow(e, 12), 2 * std::pow(e, 4)};
  expect_close(ratio(b, a), {3.5, 3.5 / std::pow(e, 5), 3.5 * std::pow(e, 13)});
}

TEST(Ratio, SwappingGivesTheReciprocal) {
  const Interval a{31, 30, 37};
  const Interval b{22, 21.5, 22.1};
  expect_close(ratio(a, b), inverse(ratio(b, a)));
}

TEST(Ratio, NoTimeIsUnresolved) {
  EXPECT_EQ(metric::verdict(ratio({1, 0, 2}, {1, 1, 1})), metric::Verdict::unresolved);
  EXPECT_EQ(metric::verdict(ratio({1, 1, 1}, {-1, -1, -1})), metric::Verdict::unresolved);
  EXPECT_EQ(metric::verdict(ratio({1, 2, 1}, {1, 1, 1})), metric::Verdict::unresolved);
}

/// Simulated times of a run; their distribution is skewed, as that of measured times.
std::vector<double> run(std::mt19937_64& words, double scale) {
  std::vector<double> times(101);
  const auto time = [&] { return scale * (1 + std::pow(static_cast<double>(words() >> 11U) * 0x1p-53, 4)); };
  std::ranges::generate(times, time);
  return times;
}

// The medians' intervals cover 99 %, and so must the ratio's: less than 1 % of 4000 runs may miss the truth. The limit
// in the test leaves three standard deviations of that count.
TEST(Ratio, CoversTheTruth) {
  std::mt19937_64 words{1};
  constexpr int runs = 4000;
  int missed = 0;
  for (int k = 0; k < runs; ++k) {
    const auto a = metric::median_interval(run(words, 2), metric::timing_confidence);
    const auto b = metric::median_interval(run(words, 3), metric::timing_confidence);
    const auto found = ratio(b, a);
    if (found.low > 1.5 || found.high < 1.5) ++missed;
  }
  EXPECT_LE(missed, 40 + 3 * std::sqrt(40.0));
  EXPECT_GT(missed,
            0);  // an interval that is never wrong is too wide to be of use
}

}  // namespace
}  // namespace bezierbench::compare
