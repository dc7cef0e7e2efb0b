// SPDX-License-Identifier: MIT
#include "experiments/sample/weights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "experiments/sample/draw.hpp"

namespace bezierbench::sample {
namespace {

constexpr int trials = 4000;

template <class G>
Cell rational_cell() {
  return {Form::rational, 2, 4, 10, {}, std::string(G::info.id)};
}

template <class G>
class WeightsTest : public ::testing::Test {};
using Weighted = ::testing::Types<WeightsMild, WeightsWild>;
TYPED_TEST_SUITE(WeightsTest, Weighted);

TYPED_TEST(WeightsTest, FollowWhatContinuousDraws) {
  const Cell cell = rational_cell<TypeParam>();
  Trial trial;
  draw(3, 5, cell, 7, trial);
  Words words(3, 5, key(cell), 7);
  EXPECT_EQ(trial.t, Continuous::parameter(words, cell.t_interval));
  for (const double x : trial.coefficients) EXPECT_EQ(x, Continuous::coordinate(words, cell.coordinate_range));
}

TEST(WeightsMild, AreUniform) {
  const Sampler sampler(1, "a", rational_cell<WeightsMild>());
  Trial trial;
  double sum = 0;
  double least = 2;
  double most = 0.5;
  for (std::uint64_t i = 0; i < trials; ++i) {
    sampler.draw(i, trial);
    for (const double w : trial.weights) {
      ASSERT_TRUE(w >= 0.5 && w <= 2);
      sum += w;
      least = std::min(least, w);
      most = std::max(most, w);
    }
  }
  const double n = 5.0 * trials;
  EXPECT_NEAR(sum / n, 1.25, 5 * 1.5 / std::sqrt(12 * n));  // five standard deviations
  EXPECT_LT(least, 0.501);
  EXPECT_GT(most, 1.999);
}

TEST(WeightsWild, HaveEveryBinadeAsOften) {
  const Sampler sampler(1, "a", rational_cell<WeightsWild>());
  Trial trial;
  std::map<int, int> count;
  double mantissas = 0;
  for (std::uint64_t i = 0; i < trials; ++i) {
    sampler.draw(i, trial);
    for (const double w : trial.weights) {
      ASSERT_GT(w, 0);
      const int exponent = std::ilogb(w);
      ++count[exponent];
      mantissas += std::ldexp(w, -exponent);
    }
  }
  const double n = 5.0 * trials;
  ASSERT_EQ(count.size(), 41U);
  EXPECT_EQ(count.begin()->first, -20);
  EXPECT_EQ(count.rbegin()->first, 20);
  for (const auto& [exponent, times] : count) EXPECT_NEAR(times, n / 41, 5 * std::sqrt(n * 40) / 41) << exponent;
  EXPECT_NEAR(mantissas / n, 1.5, 5 / std::sqrt(12 * n));
}

}  // namespace
}  // namespace bezierbench::sample
