// SPDX-License-Identifier: MIT
#include "reference/length/length_truth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "reference/length/true_length.hpp"

namespace bezierbench::reference {

namespace {

double to_float(double value) { return static_cast<float>(value); }

double uniform(std::mt19937_64& words) { return static_cast<double>(words() >> 11U) * 0x1p-53; }

/// Smooth curves, whole numbers (cusps, turns, points), nearly flat ones, and curves far from the origin or tiny.
std::vector<double> any_curve(std::mt19937_64& words, std::size_t kind, int dimension, int degree) {
  std::vector<double> points;
  for (int i = 0; i < (degree + 1) * dimension; ++i) {
    const double whole = static_cast<double>(words() % 7) - 3;
    const std::array<double, 5> choices{2 * uniform(words) - 1, whole, i % dimension == 0 ? whole : 1e-6 * whole,
                                        1e10 + uniform(words), 0x1p-200 * uniform(words)};
    points.push_back(choices[kind]);
  }
  return points;
}

CurveView<double> curve_view(const std::vector<double>& points, int dimension) {
  return {Form::bernstein, dimension, static_cast<int>(points.size()) / dimension - 1, points};
}

/// Near `value`: itself, its neighbour, some 1e-12, 1e-6 of it away, and far.
std::array<double, 5> near(double value) {
  return {value, std::nextafter(value, 2 * value), value * (1 + 1e-12), value * (1 - 1e-6), value / 3};
}

TEST(LengthTruth, HasTheBitsOfTheDigits) {
  std::mt19937_64 words(1);
  int trials = 0;
  int required = 0;
  for (std::size_t kind = 0; kind < 5; ++kind)
    for (const int dimension : {1, 2, 3})
      for (const int degree : {1, 2, 3, 6, 24}) {
        const auto points = any_curve(words, kind, dimension, degree);
        for (const auto& [from, to] : {std::array{0.0, 1.0}, {0.25, 0.7}}) {
          const LengthTruth pairs(curve_view(points, dimension), from, to, Tier::certified);
          const LengthTruth digits(curve_view(points, dimension), from, to, Tier::exact);
          const TrueLength truth(curve_view(points, dimension), from, to);
          const double length = truth.value().convert_to<double>();
          ASSERT_EQ(pairs.length(), length) << kind << " " << dimension << " " << degree;
          EXPECT_EQ(digits.length(), length);
          for (const double answer : near(length)) {
            const double error = to_float(truth.error_of(answer));
            ASSERT_EQ(pairs.error_of(answer, to_float), error) << kind << " " << dimension << " " << degree;
            EXPECT_EQ(digits.error_of(answer, to_float), error);
          }
          EXPECT_TRUE(digits.needed_digits());
          ++trials;
          required += dimension > 1 && degree > 1 && pairs.needed_digits() ? 1 : 0;
        }
      }
  EXPECT_LT(required, trials / 5);  // what is exact needs them
}

/// The interval that decides contains the error in 70 digits: the length itself is where a fault would show first.
TEST(LengthTruth, PairsAreWithinTheirUncertainty) {
  std::mt19937_64 words(2);
  for (std::size_t kind = 0; kind < 4; ++kind)
    for (const int dimension : {1, 2, 3})
      for (const int degree : {1, 2, 3, 6, 12, 24}) {
        const auto points = any_curve(words, kind, dimension, degree);
        const auto h = hodograph<PairReal>(curve_view(points, dimension), 0, 1);
        if (h.polygon() == 0) continue;
        const LengthPanels<PairReal> pairs(h);
        const TrueLength truth(curve_view(points, dimension), 0, 1);
        const Pair length = pairs.length().pair();
        const LongReal off = abs(LongReal(length.high) + LongReal(length.low) - truth.value());
        const LongReal uncertain = LongReal(pairs.uncertainty().pair().high) * (1 + LongReal("1e-10"));
        ASSERT_LE(off, uncertain + truth.uncertainty()) << kind << " " << dimension << " " << degree;
        EXPECT_LE(uncertain, truth.value() * LongReal(degree < 20 ? "1e-24" : "1e-18")) << kind << " " << degree;
      }
}

TEST(LengthTruth, AsksTheDigitsWhereAMethodIsExact) {
  const std::vector<double> line{1, 2, 4, 6};
  const LengthTruth truth(curve_view(line, 2), 0, 1, Tier::certified);
  EXPECT_EQ(truth.error_of(5.25, to_float), 0.25);
  EXPECT_FALSE(truth.needed_digits());
  EXPECT_EQ(truth.error_of(5, to_float), 0);
  EXPECT_TRUE(truth.needed_digits());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(truth.error_of(nan, to_float), std::numeric_limits<double>::infinity());
}

TEST(LengthTruth, LeavesExtremesToTheDigits) {
  for (const double size : {0x1p-310, 0x1p+310}) {
    const std::vector<double> points{0, 0, size, 3 * size, 2 * size, -size};
    const LengthTruth truth(curve_view(points, 2), 0, 1, Tier::certified);
    EXPECT_EQ(truth.length(), TrueLength(curve_view(points, 2), 0, 1).value().convert_to<double>());
    EXPECT_TRUE(truth.needed_digits());
  }
  std::mt19937_64 words(3);
  const auto points = any_curve(words, 0, 2, 25);
  const LengthTruth truth(curve_view(points, 2), 0, 1, Tier::certified);
  EXPECT_EQ(truth.length(), TrueLength(curve_view(points, 2), 0, 1).value().convert_to<double>());
  EXPECT_TRUE(truth.needed_digits());
}

TEST(AlongTruth, HasTheBitsOfTheDigits) {
  std::mt19937_64 words(4);
  int trials = 0;
  int required = 0;
  for (std::size_t kind = 0; kind < 4; ++kind)
    for (const int dimension : {1, 2, 3})
      for (const int degree : {1, 2, 3, 6}) {
        const auto points = any_curve(words, kind, dimension, degree);
        const AlongTruth pairs(curve_view(points, dimension), Tier::certified);
        const AlongTruth digits(curve_view(points, dimension), Tier::exact);
        ASSERT_EQ(pairs.whole(), digits.whole());
        for (const double share : {0.0, 1e-9, uniform(words), 0.5, 1.0}) {
          const double target = pairs.length_at_share(share);
          ASSERT_EQ(target, digits.length_at_share(share));
          const LengthAlong<LongReal> along(curve_view(points, dimension));
          const double t = along.parameter_at(LongReal(target)).convert_to<double>();
          for (const double answer : near(t)) {
            ASSERT_EQ(pairs.error_of_length(answer, target, to_float), digits.error_of_length(answer, target, to_float))
                << kind << " " << dimension << " " << degree << " " << share;
            ASSERT_EQ(pairs.error_of_parameter(answer, target, to_float),
                      digits.error_of_parameter(answer, target, to_float))
                << kind << " " << dimension << " " << degree << " " << share;
          }
        }
        ++trials;
      }
  // At the ends the digits say what is exact; a share within needs them rarely.
  for (int trial = 0; trial < 30; ++trial) {
    const auto points = any_curve(words, 0, 2, 4);
    const AlongTruth pairs(curve_view(points, 2), Tier::certified);
    const double target = pairs.length_at_share(0.25 + uniform(words) / 2);
    static_cast<void>(pairs.error_of_length(0.3, target, to_float));
    static_cast<void>(pairs.error_of_parameter(0.3, target, to_float));
    required += pairs.needed_digits() ? 1 : 0;
  }
  EXPECT_EQ(trials, 48);
  EXPECT_LE(required, 2);
}

}  // namespace

namespace {

CurveView<double> view(const std::vector<double>& points, int dimension) {
  return {Form::bernstein, dimension, static_cast<int>(points.size()) / dimension - 1, points};
}

/// Within 10^-30 of `unit`.
void expect_close(const LongReal& value, const LongReal& expected, const LongReal& unit) {
  EXPECT_LE(abs(value - expected), unit * LongReal("1e-30")) << value << " " << expected;
}

TEST(LengthAlong, IsTheKnownOneBothWays) {
  const std::vector<double> line{1, 2, 4, 6};
  expect_close(LengthAlong<LongReal>(view(line, 2)).parameter_at(LongReal("1.25")), LongReal("0.25"), 1);
  // (t, t^2): s(t) = t sqrt(1 + 4 t^2) / 2 + asinh(2 t) / 4
  const std::vector<double> parabola{0, 0, 0.5, 0, 1, 1};
  const LengthAlong<LongReal> bent(view(parabola, 2));
  for (const double place : {0x1p-30, 0.125, 0.4, 0.75, 1.0}) {
    const LongReal t = place;
    const LongReal root = sqrt(1 + 4 * t * t);
    const LongReal s = t * root / 2 + log(2 * t + root) / 4;
    expect_close(bent.length_to(t), s, bent.whole());
    expect_close(bent.parameter_at(s), t, 1);
  }
  // 3 (u^2, u^3), u = 2t - 1: s = (13 sqrt(13) -+ (4 + 9 u^2)^(3/2)) / 9 about the cusp
  const std::vector<double> cusp{3, -3, -1, 3, -1, -3, 3, 3};
  const LengthAlong<LongReal> cusped(view(cusp, 2));
  const LongReal half = (13 * sqrt(LongReal(13)) - 8) / 9;
  for (const double place : {-0.75, -0x1p-20, 0.0, 0x1p-12, 0.5}) {
    const LongReal u = place;
    const LongReal arc = (pow(4 + 9 * u * u, LongReal(1.5)) - 8) / 9;
    expect_close(cusped.length_to((1 + u) / 2), u < 0 ? half - arc : half + arc, half);
  }
  EXPECT_LE(abs(cusped.parameter_at(half) - 0.5), LongReal("1e-16"));  // the root of a rounding: s - half is like u |u|
}

TEST(LengthAlong, TurnsWhereALineTurns) {
  const std::vector<double> turn{0, 2, -1};  // 4t - 5t^2: up 4/5, then down
  const LengthAlong<LongReal> along(view(turn, 1));
  expect_close(along.length_to(LongReal(1)), LongReal(13) / 5, 1);
  expect_close(along.length_to(LongReal(3) / 5), LongReal(1), 1);  // 4/5 + (4/5 - 3/5)
  expect_close(along.parameter_at(LongReal(1)), LongReal(3) / 5, 1);
}

TEST(LengthAlong, EndsAreEnds) {
  const std::vector<double> parabola{0, 0, 0.5, 0, 1, 1};
  const LengthAlong<LongReal> along(view(parabola, 2));
  EXPECT_EQ(along.parameter_at(-1), 0);
  EXPECT_EQ(along.parameter_at(0), 0);
  EXPECT_EQ(along.parameter_at(along.whole()), 1);
  EXPECT_FALSE(signbit(along.length_to(0)));
  // (t, t^2) goes on: s(t) = t sqrt(1 + 4 t^2) / 2 + asinh(2 t) / 4
  for (const LongReal& t : {LongReal(2), 1 + LongReal(2.4e-10), LongReal(-1), LongReal(-1e-10)}) {
    const LongReal root = sqrt(1 + 4 * t * t);
    expect_close(along.length_to(t), t * root / 2 + log(2 * t + root) / 4, along.whole());
    EXPECT_GT(along.distance(t, t < 0 ? LongReal(0) : along.whole()), 0);
  }
  const std::vector<double> point{0.1, 0.2, 0.1, 0.2};
  EXPECT_EQ(LengthAlong<LongReal>(view(point, 2)).whole(), 0);
  EXPECT_EQ(LengthAlong<LongReal>(view(point, 2)).parameter_at(0), 0);
}

TEST(LengthAlong, KnowsWhichParametersItKnows) {
  const std::vector<double> rests{0, 0, 0, 1};  // s(t) = t^3
  const LengthAlong<LongReal> along(view(rests, 1));
  const auto known = along.known_parameter_at(LongReal("0.125"));
  ASSERT_TRUE(known);
  expect_close(*known, LongReal("0.5"), 1);
  EXPECT_EQ(along.known_parameter_at(0), LongReal(0));
  EXPECT_EQ(along.known_parameter_at(1), LongReal(1));
  for (const char* length : {"1e-30", "1e-36", "1e-45"}) {
    const auto tiny = along.known_parameter_at(LongReal(length));
    if (!tiny) continue;
    EXPECT_LE(abs(*tiny * *tiny * *tiny / LongReal(length) - 1), LongReal("1e-15")) << length;
  }
}

/// Against the true length of the part, which is integrated afresh; and there and back.
TEST(LengthAlong, AgreesWithTrueLengthsOfParts) {
  std::mt19937_64 words(2);
  for (const int n : {1, 2, 3, 5, 9}) {
    std::vector<double> points;
    for (int i = 0; i < 3 * (n + 1); ++i)
      points.push_back(static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-300);
    const LengthAlong<LongReal> along(view(points, 3));
    for (const double t : {0x1p-40, 0.1, 0.5, 0.77, 1 - 0x1p-40}) {
      const TrueLength part(view(points, 3), 0, t);
      expect_close(along.length_to(LongReal(t)), part.value(), along.whole());
      expect_close(along.length_to(along.parameter_at(part.value())), part.value(), along.whole());
    }
  }
}

}  // namespace

}  // namespace bezierbench::reference
