// SPDX-License-Identifier: MIT
// Random words against published answers, and affine() against arbitrary-precision integers in units of 2^-1204, of which
// every double and every image is a multiple.
#include "experiments/sample/words.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace bezierbench::sample {
namespace {

// The lines `philox4x64 10` of kat_vectors in the Random123 distribution (Salmon, Moraes, Dror, Shaw, SC'11).
TEST(Philox, GivesThePublishedKnownAnswers) {
  constexpr std::uint64_t ones = ~std::uint64_t{0};
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
            (Block{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}));
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Block{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}));
  EXPECT_EQ(philox({0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89},
                   {0x452821e638d01377, 0xbe5466cf34e90c6c}),
            (Block{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}));
}

TEST(Words, AreTheBlocksOfATrialInOrder) {
  Words words(1, 2, 3, 4);
  for (std::uint64_t block = 0; block < 3; ++block) {
    for (const std::uint64_t expected : philox({2, 3, 4, block}, {1, 0})) EXPECT_EQ(words.next(), expected);
  }
}

TEST(Words, UniformHasTheHighWordFirst) {
  Words words(1, 2, 3, 4);
  Words same(1, 2, 3, 4);
  const Uniform128 u = words.next_uniform();
  EXPECT_EQ(u.high, same.next());
  EXPECT_EQ(u.low, same.next());
}

using Integer = boost::multiprecision::cpp_int;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::denorm_min();
constexpr std::uint64_t ones = ~std::uint64_t{0};

Integer exact(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // x = fraction 2^exponent
  const Integer digits = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int shift = exponent - 53 + 1204;
  return shift >= 0 ? Integer(digits << shift)
                    : Integer(digits / (Integer(1) << -shift));  // exact: shift < 0 for 0 only
}

Integer exact_image(double a, double b, Uniform128 u) {
  const Integer k = 2 * ((Integer(u.high) << 64) + u.low) + 1;
  return exact(a) * (Integer(1) << 129) + (exact(b) - exact(a)) * k;  // in units of 2^-1333
}

/// Expects the double nearest to the image, and the even one where two are equally near.
void expect_rounded(double a, double b, Uniform128 u) {
  SCOPED_TRACE(::testing::Message() << std::hexfloat << a << " " << b << " " << std::hex << u.high << " " << u.low);
  const double got = affine(a, b, u);
  ASSERT_TRUE(got >= a && got <= b) << got;
  const Integer image = exact_image(a, b, u);
  const Integer difference = image - (exact(got) << 129);
  if (difference == 0) {
    EXPECT_TRUE(got != 0 || !std::signbit(got));
    return;
  }
  const bool up = difference > 0;
  const double neighbour = std::nextafter(got, up ? largest : -largest);
  const Integer gap = abs(exact(neighbour) - exact(got)) << 129;
  const Integer twice = 2 * abs(difference);
  EXPECT_LE(twice, gap);
  if (twice == gap) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(got) & 1U, 0U);
  }
  if (got == 0) {
    EXPECT_EQ(std::signbit(got), image < 0);
  }
}

TEST(Affine, RoundsOnceForEveryKindOfInterval) {
  const std::vector<double> ends{0.0,      tiny,        3 * tiny, 0x1p-1022, 0x1.fffffffffffffp-1022,
                                 0x1p-600, 1e-6,        0.2,      0.5,       1 - 0x1p-53,
                                 1.0,      1 + 0x1p-52, 3.0,      1e3,       1e6,
                                 0x1p53,   0x1p76,      0x1p127,  0x1p129,   0x1.8p130,
                                 0x1p500,  largest};
  std::vector<double> all;
  for (const double x : ends) {
    all.push_back(x);
    all.push_back(-x);
  }
  std::mt19937_64 random(1);
  for (const double a : all) {
    for (const double b : all) {
      if (!(a <= b)) continue;
      for (const Uniform128 u :
           {Uniform128{0, 0}, Uniform128{ones, ones}, Uniform128{ones >> 1U, ones}, Uniform128{ones >> 1U, ones - 1},
            Uniform128{1ULL << 63U, 0}, Uniform128{0, 1}, Uniform128{ones, ones - 1}, Uniform128{random(), random()}}) {
        expect_rounded(a, b, u);
      }
      if (HasFailure()) return;
    }
  }
}

TEST(Affine, RoundsOnceForRandomBits) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    double a = std::bit_cast<double>(random());
    if (!std::isnormal(a)) continue;
    double b = std::bit_cast<double>(random());
    if (i % 2 == 0) b = std::ldexp(1 + 0x1p-53 * static_cast<double>(random() >> 11U), std::ilogb(a) + i % 300 - 150);
    if (!std::isfinite(b)) continue;
    if (b < a) std::swap(a, b);
    // Numbers with few bits set make sums cancel and tie.
    const Uniform128 u{random() >> (random() % 64), i % 3 == 0 ? 0 : random()};
    expect_rounded(a, b, u);
    if (HasFailure()) return;
  }
}

/// U for which the terms cancel as far as they can, with exponents far apart and close together.
TEST(Affine, SurvivesCancellation) {
  std::mt19937_64 random(3);
  for (int apart = 0; apart < 200; ++apart) {
    for (int i = 0; i < 20; ++i) {
      const double a = -(1 + 0x1p-52 * static_cast<double>(random() >> 12U));
      const double b = std::ldexp(i % 4 == 0 ? -a : 1 + 0x1p-52 * static_cast<double>(random() >> 12U), apart);
      const Integer root = (-exact(a) << 129) / (exact(b) - exact(a)) / 2;  // the U whose image is nearest zero
      for (int step = -2; step <= 2; ++step) {
        const Integer u = root + step;
        if (u < 0 || u >= (Integer(1) << 128)) continue;
        const Uniform128 near{static_cast<std::uint64_t>(u >> 64), static_cast<std::uint64_t>(u & ones)};
        expect_rounded(a, b, near);
        // By symmetry, the same with the large term on the other side.
        expect_rounded(-b, -a, {~near.high, ~near.low});
      }
      if (HasFailure()) return;
    }
  }
}

TEST(Affine, TiesGoToEven) {
  const double b = 0x1p129;                                      // the image is 2U + 1
  EXPECT_EQ(affine(0, b, {0, 1ULL << 52U}), 0x1p53);             // 2^53 + 1
  EXPECT_EQ(affine(0, b, {0, (1ULL << 52U) + 1U}), 0x1p53 + 4);  // 2^53 + 3
  EXPECT_EQ(affine(-b, 0, {ones, ~(1ULL << 52U)}), -0x1p53);     // -(2^53 + 1)
  EXPECT_EQ(affine(0, 0x1p-946, {0, 0}), 0);                     // half the smallest double
  EXPECT_EQ(affine(0, 0x1p-946, {0, 1}), 2 * tiny);              // one and a half
  EXPECT_TRUE(std::signbit(affine(-0x1p-946, 0, {ones, ones})));
}

/// A term that is far smaller than half an ulp breaks a tie.
TEST(Affine, ATieIsBrokenByTheFarTerm) {
  const double b = 0x1p129;
  for (int exponent = 20; exponent >= -1074; --exponent) {
    for (const double a : {std::ldexp(1.0, exponent), std::ldexp(-1.0, exponent)}) {
      for (const std::uint64_t low : {1ULL << 52U, (1ULL << 52U) + 1U}) {
        expect_rounded(a, b, {0, low});
        expect_rounded(-b, -a, {ones, ~low});
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_EQ(affine(tiny, b, {0, 1ULL << 52U}), 0x1p53 + 2);
  EXPECT_EQ(affine(-tiny, b, {0, (1ULL << 52U) + 1U}), 0x1p53 + 2);
}

}  // namespace

}  // namespace bezierbench::sample
