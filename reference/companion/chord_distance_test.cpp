// SPDX-License-Identifier: MIT
#include "reference/companion/chord_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/exact_curve.hpp"

namespace bezierbench::reference {
namespace {

CurveView<double> in_plane(const std::vector<double>& control_points) {
  return {Form::bernstein, 2, static_cast<int>(control_points.size()) / 2 - 1, control_points};
}

ChordJudgement whole_judged(const std::vector<double>& control_points, double tolerance) {
  const auto curve = in_plane(control_points);
  const std::span all(control_points);
  return judge_chord(ScaledCurve(curve), 0, 1, all.first(2), all.last(2), tolerance);
}

/// Its apex is (1, 1), one above the chord, and no point is farther.
TEST(ChordDistance, OfAParabolaIsThatOfItsApex) {
  const std::vector<double> parabola{0, 0, 1, 2, 2, 0};
  const auto [distance, kept] = whole_judged(parabola, 2);
  EXPECT_EQ(kept, Kept::proved);
  EXPECT_LE(distance.low, 1);
  EXPECT_GE(distance.high, 1);
  EXPECT_LE(distance.high - distance.low, 0x1p-9);
}

TEST(ChordDistance, IsComparedExactlyWithTheTolerance) {
  const std::vector<double> parabola{0, 0, 1, 2, 2, 0};
  EXPECT_EQ(whole_judged(parabola, 1).kept, Kept::proved);
  EXPECT_EQ(whole_judged(parabola, std::nextafter(1, 0)).kept, Kept::refuted);
  const std::vector<double> tiny{0, 0, 0x1p-900, 0x1p-899, 0x1p-899, 0};
  EXPECT_EQ(whole_judged(tiny, 0x1p-900).kept, Kept::proved);
  EXPECT_EQ(whole_judged(tiny, std::nextafter(0x1p-900, 0)).kept, Kept::refuted);
}

/// (1, 0) is reached at t = 1/2 from (0, 0), and the curve returns: it leaves the chord along its line.
TEST(ChordDistance, IsThatOfTheSegmentNotOfItsLine) {
  const std::vector<double> spike{0, 0, 2, 0, 0, 0};
  EXPECT_EQ(whole_judged(spike, 1).kept, Kept::proved);
  EXPECT_EQ(whole_judged(spike, std::nextafter(1, 0)).kept, Kept::refuted);
}

/// The point at t = 1/2 is (1, 1); over [0, 1/2] the middle of the chord is (1/2, 1/2), the curve at (1/2, 3/4).
TEST(ChordDistance, OfAPieceIsThatOfItsParameters) {
  const std::vector<double> parabola{0, 0, 1, 2, 2, 0};
  const auto curve = in_plane(parabola);
  const std::vector<double> apex{1, 1};
  const double distance = 0.25 / std::sqrt(2.0);
  const auto judgement = judge_chord(ScaledCurve(curve), 0, 0.5, std::span(parabola).first(2), apex, 1);
  EXPECT_NEAR(judgement.distance.low, distance, 1e-3);
  EXPECT_LE(judgement.distance.low, distance);
  EXPECT_GE(judgement.distance.high, distance);
}

/// The chord goes on to (2, 0), 1 beyond the end of the curve, although every point of the curve lies on the chord.
TEST(ChordDistance, CountsTheEndsOfTheChord) {
  const std::vector<double> line{0, 0, 1, 0};
  const std::vector<double> longer{2, 0};
  const auto curve = in_plane(line);
  const auto judgement = judge_chord(ScaledCurve(curve), 0, 1, std::span(line).first(2), longer, 0.5);
  EXPECT_EQ(judgement.kept, Kept::undecided);  // no point of the piece is off, and one of the chord is
  EXPECT_GE(judgement.distance.high, 1);
}

/// Weights of two signs whose sum is 4e-15 at its least, next to which doubles know little: no enclosure ends below a
/// true point, and no tolerance below it counts as kept.
TEST(ChordDistance, NextToAPoleNothingWrongIsProved) {
  const std::vector<double> points{0.686789687751457,  0.03440889102532596, -0.9544003990192389,
                                   0.8403649283166097, 0.374552277738742,   0.15477492546042937};
  const std::vector<double> weights{1, -3.6918028870831114, 13.629408557075534};
  const CurveView<double> curve{Form::rational, 2, 2, points, weights};
  const ScaledCurve scaled(curve);
  ExactCurve exact;
  const auto at = [&](double t) {
    const auto& point = exact.point(curve, t);
    return std::vector<double>{round_to(binary64, point.coordinate(0)), round_to(binary64, point.coordinate(1))};
  };
  const double pole = (weights[0] - weights[1]) / (weights[0] - 2 * weights[1] + weights[2]);  // where W is least
  int judged = 0;
  for (int k = 2; k < 40; ++k) {
    const double from = std::floor(std::ldexp(pole, k)) * std::ldexp(1, -k);
    const double to = from + std::ldexp(1, -k);
    const auto start = at(from);
    const auto end = at(to);
    double sampled = 0;
    for (int j = 1; j < 64; ++j) {
      const auto point = at(j == 1 ? pole : from + (to - from) * j / 64);
      sampled =
          std::max(sampled, distance_to_segment({point[0], point[1], 0}, {start[0], start[1], 0}, {end[0], end[1], 0}));
    }
    const double certain = sampled - 0x1p-48 * (std::abs(start[0]) + std::abs(end[0]));  // points are rounded
    if (!(certain > 0)) continue;
    const auto judgement = judge_chord(scaled, from, to, start, end, certain * (1 - 1e-6));
    EXPECT_GE(judgement.distance.high, certain) << k;
    EXPECT_NE(judgement.kept, Kept::proved) << k;
    ++judged;
  }
  EXPECT_GT(judged, 20);
}

LeastChords least(const std::vector<double>& control_points, double tolerance) {
  const auto curve = in_plane(control_points);
  return least_chords(ScaledCurve(curve), tolerance);
}

void expect_exactly(const LeastChords& bounds, int count) {
  EXPECT_EQ(bounds.low, count);
  EXPECT_EQ(bounds.high, count);
}

TEST(LeastChords, OfLinesAndSpikes) {
  expect_exactly(least({0, 0, 1, 3, 2, 6, 3, 9}, 1e-6), 1);
  expect_exactly(least({5, 5, 5, 5, 5, 5}, 1e-6), 1);
  expect_exactly(least({0, 0, 2, 0, 0, 0}, 1.001), 1);
  expect_exactly(least({0, 0, 2, 0, 0, 0}, 0.9), 2);
}

/// y = x^2 over [-1/2^k, 1/2^k] is nearly (x, 0): the distance of a chord of width w is w^2/4, of any place, except for
/// the slope, below 2^(1-k). So a width of 2 r takes r/sqrt(E) chords.
TEST(LeastChords, OfAFlatParabolaAreItsWidthOverThatOfAChord) {
  const double r = 0x1p-10;
  const std::vector<double> parabola{-r, r * r, 0, -r * r, r, r * r};
  for (const int count : {2, 3, 5, 16, 40}) {
    const double exact = r * r / count / count;
    expect_exactly(least(parabola, exact * (1 + 0.1 / count)), count);
    expect_exactly(least(parabola, exact * (1 - 0.1 / count)), count + 1);
  }
}

/// A chord of angle a is r (1 - cos(a/2)) from a circle of radius r. The cubic is within 2.8e-4 of the quarter circle.
TEST(LeastChords, OfAQuarterCircleAreThoseOfTheCircle) {
  const double k = 0.5522847498;
  const std::vector<double> quarter{1, 0, 1, k, k, 1, 0, 1};
  const double angle = std::asin(1.0) / 7;
  expect_exactly(least(quarter, 1.06 * (1 - std::cos(angle / 2))), 7);
}

}  // namespace
}  // namespace bezierbench::reference
