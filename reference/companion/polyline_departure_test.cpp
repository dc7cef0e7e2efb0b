// SPDX-License-Identifier: MIT
#include "reference/companion/polyline_departure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace bezierbench::reference {

namespace {

using Data = std::vector<double>;
using Places = std::vector<NearPlace>;

/// The curve of issue trackers: five points on a line, nearly, and handles of 1543 beside steps of 1. It leaves the
/// polyline by more than half the way to a control point that is 1540 away from it: x(t) = 4 t^3 - 4629 (1-t)^2 t +
/// 4639 (1-t) t^2 is -444.8 at its least.
TEST(Departure, SeesACurveThatRunsAwayBetweenThePoints) {
  const Data points{0, 0, 1, 0.01, 2, 0, 3, 0.01, 4, 0};
  const Data curve{0, 0, -1543, 0.009, 1546, 0.009, 4, 0};
  const auto found =
      departure_from_polyline(2, points, curve, Places{{0, 0}, {0, 0.4995}, {0, 0.4998}, {0, 0.5}, {0, 1}}, 0.1);
  EXPECT_NEAR(found.distance, 444.8, 0.5);
  EXPECT_GT(found.over_limit, 1000);
  EXPECT_NEAR(found.handle, 1543 / 4.0, 0.1);
}

/// A straight curve beside a straight polyline, at distance 1 with a tolerance of 1: 5/2 is allowed. D is 0.
TEST(Departure, ComparesWithTheLimit) {
  const Data points{0, 0, 1, 0, 2, 0, 3, 0};
  const Data curve{0, 1, 1, 1, 2, 1, 3, 1};
  const auto found = departure_from_polyline(2, points, curve, Places{{0, 0}, {0, 1. / 3}, {0, 2. / 3}, {0, 1}}, 1);
  EXPECT_DOUBLE_EQ(found.distance, 1);
  EXPECT_NEAR(found.over_limit, 1 / 2.5, 1e-12);
  EXPECT_NEAR(found.handle, 1. / 3, 1e-12);
}

/// Between integers of 2^52 a third of the way is rounded by 1/3 or so, however small the tolerance is.
TEST(Departure, AllowsTheRoundingsOfControlPoints) {
  const double far = 0x1p+52;
  const Data points{far, far, far + 2, far + 1};
  const Data curve{far, far, far + 1, far, far + 1, far + 1, far + 2, far + 1};
  const auto found = departure_from_polyline(2, points, curve, Places{{0, 0}, {0, 1}}, 1e-9);
  EXPECT_GT(found.distance, 0.1);
  EXPECT_LE(found.over_limit, 1);
  const Data near{0, 0, 2, 1};
  const Data bent{0, 0, 1, 0, 1, 1, 2, 1};
  EXPECT_GT(departure_from_polyline(2, near, bent, Places{{0, 0}, {0, 1}}, 1e-9).over_limit, 1);
}

/// The straight curve stays on the polyline. The data run back on it; a curve that passes the points in another order
/// than given is one away from those that it does not pass in turn.
TEST(Departure, SeesTheOrderOfThePoints) {
  const Data points{0, 0, 2, 0, 1, 0, 3, 0};
  const Data curve{0, 0, 1, 0, 2, 0, 3, 0};
  EXPECT_NEAR(departure_from_polyline(2, points, curve, Places{{0, 0}, {0, 2. / 3}, {0, 1. / 3}, {0, 1}}, 0.1).distance,
              0, 1e-15);
  EXPECT_DOUBLE_EQ(
      departure_from_polyline(2, points, curve, Places{{0, 0}, {0, 1. / 3}, {0, 2. / 3}, {0, 1}}, 0.1).distance, 1);
}

/// Of steps (4,0) and (4,3), the difference is (0,3), so that s = 3/8. Of (4,0) and (0.8,0.6) it is (-3.2,0.6), but the
/// only neighbour of the long step, and the short step itself, have length 1, so that s = 2/8. A right angle is a
/// corner.
TEST(Departure, AllowsWhatTheSamplingLeavesOpen) {
  const auto limit = [](const Data& points, double tolerance) {
    const Data away{0, 0, 0, -1, 0, -1, points[4], points[5]};
    const auto found = departure_from_polyline(2, points, away, Places{{0, 0}, {0, 1}, {0, 1}}, tolerance);
    return found.distance / found.over_limit;
  };
  EXPECT_NEAR(limit({0, 0, 4, 0, 8, 3}, 0), 3.0 / 8, 1e-4);
  EXPECT_NEAR(limit({0, 0, 4, 0, 4.8, 0.6}, 0), 2.0 / 8, 1e-4);
  EXPECT_NEAR(limit({0, 0, 4, 0, 4, 4}, 0.5), 2.5 * 0.5, 1e-4);
}

/// What the limit is derived from: a cubic at equal steps of t, each point moved by up to the tolerance.
TEST(Departure, HoldsNothingAgainstAnEvenlyVisitedCubic) {
  std::mt19937_64 words(1);
  const auto symmetric = [&] { return static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63; };
  double most = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const int d = 1 + trial % 3;
    const int count = 4 + trial % 20;
    const double tolerance = trial % 2 == 0 ? 0 : 0x1p-6;
    Data curve{};
    for (int j = 0; j < 4; ++j)  // steps of similar lengths
      for (int axis = 0; axis < d; ++axis) curve.push_back((axis == 0 ? 2 * j : 0) + symmetric());
    Data points;
    std::vector<NearPlace> places;
    for (int i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / (count - 1);
      places.push_back({0, t});
      const double s = 1 - t;
      for (int axis = 0; axis < d; ++axis) {
        const auto b = [&](int j) { return curve[static_cast<std::size_t>(j * d + axis)]; };
        points.push_back(s * s * s * b(0) + 3 * s * s * t * b(1) + 3 * s * t * t * b(2) + t * t * t * b(3) +
                         tolerance / std::sqrt(d) * symmetric());
      }
    }
    const double found = departure_from_polyline(d, points, curve, places, tolerance).over_limit;
    EXPECT_LE(found, 1 + 1e-4) << trial;
    most = std::max(most, found);
  }
  EXPECT_GT(most, 0.99);  // without noise the limit is attained
}

}  // namespace

namespace {

using Data = std::vector<double>;

double largest(int d, const Data& points, const Data& control_points, const std::vector<NearPlace>& places) {
  return square_root(binary64, largest_squared_distance(d, points, control_points, places));
}

/// Two straight segments, from (0,0) to (3,0) and on to (3,3), and points 1, 2 and 0.5 away, wherever they are said to
/// be near.
TEST(LargestDistance, IsThatToTheNearestSegment) {
  const Data curve{0, 0, 1, 0, 2, 0, 3, 0, 3, 0, 3, 1, 3, 2, 3, 3};
  const Data points{1, 1, 5, 1.5, 2.5, 3};
  EXPECT_EQ(largest(2, points, curve, {{0, 0.25}, {1, 0.5}, {1, 1}}), 2);
  EXPECT_EQ(largest(2, points, curve, {{1, 1}, {0, 0}, {0, 0}}), 2);
  EXPECT_EQ(largest(2, {3, 0, 0, 0}, curve, {{0, 1}, {0, 0}}), 0);
}

TEST(LargestDistance, AgreesWithManySamples) {
  std::mt19937_64 words(1);
  const auto symmetric = [&] { return static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63; };
  for (int trial = 0; trial < 20; ++trial) {
    const int d = 1 + trial % 3;
    Data curve;
    Data points;
    for (int k = 0; k < 3 * 4 * d; ++k) curve.push_back(symmetric());
    for (int k = 0; k < 5 * d; ++k) points.push_back(2 * symmetric());
    double most = 0;
    for (int i = 0; i < 5; ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= 3000; ++k) {
        const int segment = std::min(k / 1000, 2);
        const double t = k / 1000.0 - segment;
        double square = 0;
        for (int axis = 0; axis < d; ++axis) {
          const auto b = [&](int j) { return curve[static_cast<std::size_t>((4 * segment + j) * d + axis)]; };
          const double s = 1 - t;
          const double offset = s * s * s * b(0) + 3 * s * s * t * b(1) + 3 * s * t * t * b(2) + t * t * t * b(3) -
                                points[static_cast<std::size_t>(i * d + axis)];
          square += offset * offset;
        }
        least = std::min(least, std::sqrt(square));
      }
      most = std::max(most, least);
    }
    const double exact = largest(d, points, curve, std::vector<NearPlace>(5, {trial % 3, 0.5}));
    EXPECT_LE(exact, most + 1e-15);
    EXPECT_GE(exact, most - 0.01);  // half a step of a speed below 12 sqrt(3)
  }
}

}  // namespace

}  // namespace bezierbench::reference
