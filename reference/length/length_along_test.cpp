// SPDX-License-Identifier: MIT
#include "reference/length/length_along.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "reference/length/true_length.hpp"

namespace bezierbench::reference {
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
