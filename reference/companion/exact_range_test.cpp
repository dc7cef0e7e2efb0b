// SPDX-License-Identifier: MIT
#include "reference/companion/exact_range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "reference/rational.hpp"

namespace bezierbench::reference {
namespace {

ExactRange range_of(const std::vector<double>& b, const std::vector<double>& w = {}) {
  return exact_range({w.empty() ? Form::bernstein : Form::rational, 1, static_cast<int>(b.size()) - 1, b, w}, 0);
}

/// Whether `low` is the largest double that is not above sign sqrt(square), and `high` the smallest not below.
void expect_root_between(double low, double high, const Rational& square, bool negative) {
  EXPECT_EQ(std::nextafter(low, high), high);
  const double inner = std::abs(negative ? high : low);
  const double outer = std::abs(negative ? low : high);
  EXPECT_TRUE(less(exactly(inner) * exactly(inner), square));
  EXPECT_TRUE(less(square, exactly(outer) * exactly(outer)));
}

TEST(ExactRange, EndsOfMonotoneCurves) {
  EXPECT_EQ(range_of({3}).low, 3);
  EXPECT_EQ(range_of({1, 4}).high, 4);
  EXPECT_EQ(range_of({5, 3, 1, -1}).low, -1);
  EXPECT_EQ(range_of({2, 2, 2}).high, 2);
}

/// (3t - 1)^2: the minimum is 0 at t = 1/3, which is not a double.
TEST(ExactRange, FindsThatAMinimumIsADouble) {
  const auto range = range_of({1, -2, 4});
  EXPECT_EQ(range.low, 0);
  EXPECT_EQ(range.high, 4);
  const auto moved = range_of({8, 5, 11});  // 7 more
  EXPECT_EQ(moved.low, 7);
}

/// b = 0, 1, -1, 0: p = 3t (1-t) (1-2t), with extrema -+ sqrt(3) / 6 at (3 -+ sqrt(3)) / 6.
TEST(ExactRange, EnclosesAnIrrationalExtremum) {
  const auto range = range_of({0, 1, -1, 0});
  const Rational twelfth{1, 12, 0};
  expect_root_between(std::nextafter(range.high, 0), range.high, twelfth, false);
  expect_root_between(range.low, std::nextafter(range.low, 0), twelfth, true);
}

/// b = 0, 1, 0: the maximum 1/2 at t = 1/2 is found without a root in between.
TEST(ExactRange, ExactAtDyadicParameters) {
  EXPECT_EQ(range_of({0, 1, 0}).high, 0.5);
  EXPECT_EQ(range_of({0, 1, 0}).low, 0);
}

/// The unit circle's quarter, y = 2t / (1 + t^2), and its arc from -60 to 60 degrees, with x = 1 in the middle.
TEST(ExactRange, RationalCurves) {
  EXPECT_EQ(range_of({0, 1, 1}, {1, 1, 2}).high, 1);
  const auto arc = range_of({0.5, 2, 0.5}, {1, 0.5, 1});
  EXPECT_EQ(arc.high, 1);
  EXPECT_EQ(arc.low, 0.5);
}

TEST(ExactRange, WeightsThatAreAllEqualChangeNothing) {
  const std::vector<double> b{0.1, 3.7, -2.9, 1.3};
  const auto range = range_of(b);
  const auto weighted = range_of(b, {0.3, 0.3, 0.3, 0.3});
  EXPECT_EQ(range.low, weighted.low);
  EXPECT_EQ(range.high, weighted.high);
}

/// Powers of two scale everything, also to the ends of the range.
TEST(ExactRange, ScalesWithPowersOfTwo) {
  const std::vector<double> b{0.1, 3.7, -2.9, 1.3};
  const auto range = range_of(b);
  for (const int exponent : {-900, 1000}) {
    std::vector<double> scaled;
    for (const double x : b) scaled.push_back(std::ldexp(x, exponent));
    EXPECT_EQ(range_of(scaled).low, std::ldexp(range.low, exponent));
    EXPECT_EQ(range_of(scaled).high, std::ldexp(range.high, exponent));
  }
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(range_of({0, tiny, 0}).high, tiny);  // half of it, rounded up
  EXPECT_EQ(range_of({0, tiny, 0}).low, 0);
}

}  // namespace
}  // namespace bezierbench::reference
