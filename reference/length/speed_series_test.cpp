// SPDX-License-Identifier: MIT
#include "reference/length/speed_series.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace bezierbench::reference {
namespace {

LongHodograph random_hodograph(std::mt19937_64& words, std::size_t degree, std::size_t dimension, double spread) {
  LongHodograph h{dimension, {}};
  for (std::size_t k = 0; k < (degree + 1) * dimension; ++k)
    h.vectors.push_back(static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63 * spread +
                        (k % dimension == 0 ? 1 : 0));
  return h;
}

/// |h(t)| by de Casteljau's algorithm.
LongReal speed_at(const LongHodograph& h, const LongReal& t) {
  auto left = h;
  left.split(t);
  LongReal square = 0;
  for (std::size_t axis = 0; axis < h.dimension; ++axis) {
    const LongReal& x = left.vectors[left.vectors.size() - h.dimension + axis];
    square += x * x;
  }
  return sqrt(square);
}

TEST(SpeedSeries, IsTheHodographAndSoAreItsHalves) {
  std::mt19937_64 words(1);
  for (const std::size_t degree : {0U, 1U, 2U, 5U, 20U, 63U})
    for (const std::size_t dimension : {1U, 2U, 3U}) {
      const auto h = random_hodograph(words, degree, dimension, 2);
      SpeedSeries<LongReal> series(h);
      SpeedSeries<LongReal> left = series;
      const SpeedSeries<LongReal> right = left.halve(SpeedSeries<LongReal>::Halving(degree));
      for (const double z : {-1.0, -0.7, 0.0, 0.3, 1.0}) {
        const LongReal y = z;
        EXPECT_LE(abs(series.speed(y) - speed_at(h, (y + 1) / 2)), LongReal("1e-62")) << degree;
        EXPECT_LE(abs(left.speed(y) - series.speed((y - 1) / 2)), LongReal("1e-62")) << degree;
        EXPECT_LE(abs(right.speed(y) - series.speed((y + 1) / 2)), LongReal("1e-62")) << degree;
        EXPECT_LE(series.speed(y), series.largest() + LongReal("1e-62"));
      }
      EXPECT_LE(abs(series.chord_to(1) - h.chord()), LongReal("1e-62"));
      auto part = h;
      part.split(LongReal(0.375));
      EXPECT_LE(abs(series.chord_to(LongReal(-0.25)) - part.chord()), LongReal("1e-62"));
    }
}

TEST(SpeedSeries, SaysByHowMuchItIsCut) {
  std::mt19937_64 words(2);
  const auto h = random_hodograph(words, 12, 2, 0.3);
  const SpeedSeries<LongReal> whole(h);
  for (const char* allowed : {"1e-40", "1e-3", "0.1"}) {
    auto series = whole;
    const LongReal cut = series.shorten(LongReal(allowed)).vectors;
    EXPECT_LE(cut, LongReal(allowed));
    for (int k = 0; k <= 50; ++k) {
      const LongReal z = LongReal(k) / 25 - 1;
      EXPECT_LE(abs(series.speed(z) - whole.speed(z)), cut + LongReal("1e-62"));
    }
  }
}

/// Against the sum over 64 parts, of which each is far more exact than the whole.
TEST(SpeedSeries, MissesNoMoreThanIsProved) {
  std::mt19937_64 words(3);
  int proofs = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const auto degree = static_cast<std::size_t>(1 + trial % 6);
    const SpeedSeries<LongReal> series(random_hodograph(words, degree, 2 + static_cast<std::size_t>(trial) % 2, 0.9));
    const LongReal missed = series.proved_miss(LongReal("1e-8"));
    if (missed < 0) continue;
    ++proofs;
    EXPECT_LE(missed, LongReal("1e-8"));
    std::vector<SpeedSeries<LongReal>> parts{series};
    const SpeedSeries<LongReal>::Halving halving(degree);
    while (parts.size() < 64) {
      std::vector<SpeedSeries<LongReal>> halves;
      for (auto& part : parts) {
        auto right = part.halve(halving);
        halves.push_back(part);
        halves.push_back(right);
      }
      parts = halves;
    }
    LongReal mean = 0;
    for (const auto& part : parts) mean += part.mean_speed_to(1) / 64;
    EXPECT_LE(abs(mean - series.mean_speed_to(1)), missed) << trial;
  }
  EXPECT_GT(proofs, 5);
}

/// h = (1, z/b) has h.h = 0 at z = ib and -ib: nothing below b + sqrt(1 + b^2) to the power -88 may be said of it.
TEST(SpeedSeries, KnowsWhereTheSpeedHasRoots) {
  for (const double b : {0.1, 0.5, 1.0, 2.0, 4.0}) {
    const SpeedSeries<LongReal> series(LongHodograph{2, {1, -1 / LongReal(b), 1, 1 / LongReal(b)}});
    const LongReal fall = pow(b + sqrt(1 + LongReal(b) * b), -88);
    for (const char* allowed : {"1e-2", "1e-10", "1e-30", "1e-60"}) {
      const LongReal missed = series.proved_miss(LongReal(allowed));
      EXPECT_TRUE(missed < 0 || missed >= fall) << b << " " << allowed;
      EXPECT_TRUE(missed < 0 || b >= 1) << b;
    }
  }
}

}  // namespace
}  // namespace bezierbench::reference
