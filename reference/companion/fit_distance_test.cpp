// SPDX-License-Identifier: MIT
#include "reference/companion/fit_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace bezierbench::reference {
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
