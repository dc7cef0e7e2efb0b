// SPDX-License-Identifier: MIT
#include "experiments/metric/tally.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "experiments/number/bytes.hpp"

namespace bezierbench::metric {
namespace {

Tally tally_of(const std::vector<double>& errors) {
  Tally tally;
  for (const double error : errors) tally.add(error);
  return tally;
}

TEST(Tally, HandComputed) {
  const Tally tally = tally_of({3, 0, 1, 4});
  EXPECT_EQ(tally.count(), 4U);
  EXPECT_EQ(tally.mean(), 2);
  EXPECT_EQ(tally.root_mean_square(), std::sqrt(6.5));
  EXPECT_EQ(tally.max(), 4);
  EXPECT_EQ(tally.quantile(0.25), 0);
  EXPECT_EQ(tally.quantile(0.5), 1);
  EXPECT_EQ(tally.quantile(0.51), 3);
  EXPECT_EQ(tally.quantile(1), 4);
}

TEST(Tally, EmptyIsZero) {
  const Tally tally;
  EXPECT_EQ(tally.count(), 0U);
  EXPECT_EQ(tally.mean(), 0);
  EXPECT_EQ(tally.root_mean_square(), 0);
  EXPECT_EQ(tally.quantile(0.5), 0);
}

TEST(Tally, QuantilesKeepEightBits) {
  // 1 + 3/256 lies in the bin that starts at 1 + 2/256 when eight bits are kept.
  EXPECT_EQ(tally_of({1 + 3.0 / 256}).quantile(0.5), 1 + 2.0 / 256);
}

TEST(Tally, SumsWithoutOverflowOrUnderflow) {
  const double huge = to_24_bits(1.5e308);
  EXPECT_EQ(tally_of({huge, huge, huge}).mean(), huge);
  EXPECT_EQ(tally_of({huge, huge, huge}).root_mean_square(), huge);
  const double tiny = 0x1p-1074;
  EXPECT_EQ(tally_of({tiny, tiny}).mean(), tiny);
  EXPECT_EQ(tally_of({tiny, 3 * tiny}).mean(), 2 * tiny);
  EXPECT_EQ(tally_of({3 * tiny, 3 * tiny}).root_mean_square(), 3 * tiny);
  EXPECT_EQ(tally_of({0x1p-997, 0x1p-997}).quantile(1), 0x1p-997);
}

TEST(Tally, SubnormalsAreCountedLikeOthers) {
  const double value = 0x1.fffffep-1023;
  Tally tally;
  for (int k = 0; k < 1 << 20; ++k) tally.add(value);
  EXPECT_EQ(tally.root_mean_square(), value);
  EXPECT_EQ(tally.mean(), value);
  EXPECT_EQ(tally_of({0x1p-1040, 0x1p-1074}).quantile(1), 0x1p-1040);
  EXPECT_EQ(tally_of({0x1p-1040, 0x1p-1074}).quantile(0.5), 0x1p-1074);
}

TEST(Tally, MeanIsCorrectlyRounded) {
  // 1/3 of 1: the exact sum divided once.
  EXPECT_EQ(tally_of({1, 0, 0}).mean(), 1.0 / 3);
  // Adding 2^-60 to 1 a million times in double loses it; here it counts.
  Tally tally;
  tally.add(1);
  for (int k = 0; k < 1 << 20; ++k) tally.add(0x1p-60);
  EXPECT_EQ(tally.mean() * ((1 << 20) + 1), 1 + 0x1p-40);
}

TEST(Tally, OrderAndGroupingChangeNothing) {
  std::mt19937_64 words(1);
  std::vector<double> errors;
  for (int k = 0; k < 5000; ++k)
    errors.push_back(to_24_bits(
        std::ldexp(1 + static_cast<double>(words() >> 12U) * 0x1p-52, static_cast<int>(words() % 300) - 150)));
  const Tally whole = tally_of(errors);
  std::shuffle(errors.begin(), errors.end(), words);
  Tally merged;
  for (std::size_t first = 0; first < errors.size();) {
    const std::size_t last = std::min(errors.size(), first + 1 + words() % 700);
    merged.merge(tally_of(
        {errors.begin() + static_cast<std::ptrdiff_t>(first), errors.begin() + static_cast<std::ptrdiff_t>(last)}));
    first = last;
  }
  EXPECT_EQ(merged.count(), whole.count());
  EXPECT_EQ(merged.mean(), whole.mean());
  EXPECT_EQ(merged.root_mean_square(), whole.root_mean_square());
  EXPECT_EQ(merged.max(), whole.max());
  for (const double q : {0.01, 0.5, 0.99, 1.0}) EXPECT_EQ(merged.quantile(q), whole.quantile(q));
  std::ranges::sort(errors);
  EXPECT_LE(whole.quantile(0.5), errors[2499]);
  EXPECT_GE(whole.quantile(0.5) * (1 + 1.0 / 128), errors[2499]);
}

Tally reread(const Tally& tally) {
  number::ByteWriter writer;
  writer(tally);
  number::ByteReader reader(writer.bytes());
  Tally copy;
  copy.add(7);  // what was there before goes
  reader(copy);
  reader.finish();
  return copy;
}

TEST(Tally, BytesKeepEverything) {
  std::mt19937_64 random(3);
  std::vector<double> errors{0, 5e-324, std::ldexp(1.0, 1023)};
  for (int k = 0; k < 3000; ++k)
    errors.push_back(std::ldexp(static_cast<double>(random() >> 40U), static_cast<int>(random() % 60) - 90));
  const Tally tally = tally_of(errors);
  const Tally copy = reread(tally);
  EXPECT_EQ(copy.count(), tally.count());
  EXPECT_EQ(copy.mean(), tally.mean());
  EXPECT_EQ(copy.root_mean_square(), tally.root_mean_square());
  EXPECT_EQ(copy.max(), tally.max());
  for (const double q : {1e-9, 0.01, 0.3, 0.5, 0.99, 1.0}) EXPECT_EQ(copy.quantile(q), tally.quantile(q));
  Tally infinite = tally;
  infinite.add_infinite();
  EXPECT_EQ(reread(infinite).count(), infinite.count());
  EXPECT_EQ(reread(infinite).max(), INFINITY);
  EXPECT_EQ(reread(Tally()).count(), 0U);
}

TEST(Tally, BytesOfNoTallyAreRefused) {
  number::ByteWriter writer;
  writer(std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0}, 1.0, std::uint64_t{1}, 1'000'000'000);
  number::ByteReader reader(writer.bytes());
  Tally tally;
  EXPECT_THROW(reader(tally), number::MalformedBytes);
}

TEST(Tally, InfiniteErrorsMakeStatisticsInfinite) {
  Tally tally = tally_of({1, 2});
  tally.add_infinite();
  EXPECT_EQ(tally.count(), 3U);
  EXPECT_TRUE(std::isinf(tally.mean()));
  EXPECT_TRUE(std::isinf(tally.max()));
  EXPECT_EQ(tally.quantile(0.5), 2);
  EXPECT_TRUE(std::isinf(tally.quantile(1)));
}

TEST(To24Bits, RoundsTiesToEven) {
  EXPECT_EQ(to_24_bits(1 + 0x1p-24), 1);
  EXPECT_EQ(to_24_bits(1 + 0x1p-23 + 0x1p-24), 1 + 0x1p-22);
  EXPECT_EQ(to_24_bits(1 + 0x1p-24 + 0x1p-52), 1 + 0x1p-23);
  EXPECT_EQ(to_24_bits(0), 0);
  EXPECT_EQ(to_24_bits(0.1), static_cast<double>(0.1F));
}

TEST(Tally, AddsSeveralAsOneByOne) {
  const std::vector<double> errors{0, 0x1p-1074, 3, 0x1p-30, std::numeric_limits<double>::infinity(), 0x1p+1000, 3};
  Tally together;
  together.add(errors);
  EXPECT_EQ(together.count(), errors.size());
  EXPECT_EQ(together.mean(), std::numeric_limits<double>::infinity());
  Tally finite;
  finite.add(std::vector<double>{0, 1, 2, 3});
  EXPECT_EQ(finite.mean(), 1.5);
  EXPECT_EQ(finite.max(), 3);
}

TEST(ErrorUnits, AreQuotientsTo24Bits) {
  ErrorLanes errors{0, 0, 1, 3, 0x1p-1074, 1, std::nextafter(1.0, 2.0)};
  ErrorLanes divisors{0, 5, 0, 2, 4, 3, 1};
  errors[15] = 7;
  divisors[15] = 0x1p+10;
  const auto units = in_units(errors, divisors);
  EXPECT_EQ(units[0], 0);
  EXPECT_EQ(units[1], 0);
  EXPECT_EQ(units[2], std::numeric_limits<double>::infinity());
  EXPECT_EQ(units[3], 1.5);
  EXPECT_EQ(units[4], 0);
  EXPECT_EQ(units[5], static_cast<double>(1.0F / 3.0F));
  EXPECT_EQ(units[6], 1);
  EXPECT_EQ(units[15], 0x7p-10);
  EXPECT_EQ(in_units(errors, divisors, 0x1p-53)[3], 0x3p+52);
}

}  // namespace
}  // namespace bezierbench::metric
