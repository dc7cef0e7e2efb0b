// SPDX-License-Identifier: MIT
// Curves whose properties can be seen.
#include "experiments/metric/curve_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bezierbench::metric {
namespace {

void add(curves::CurveSet& set, const std::vector<double>& points, int dimension = 2, Form form = Form::bernstein) {
  const auto count = points.size() / static_cast<std::size_t>(dimension);
  const std::vector<double> weights(form == Form::rational ? count : 0, 1.0);
  set.add("", {form, dimension, static_cast<int>(count) - 1, points, weights});
}

TEST(CurveStatistics, GroupsByFormAndDegree) {
  curves::CurveSet set;
  add(set, {0, 0, 1, 1});
  add(set, {0, 0, 1, 1, 2, 0});
  add(set, {-5, 0, 1, 7, 2, 0});
  add(set, {0, 0, 1, 1, 2, 0}, 2, Form::rational);
  add(set, {3, 4, 5}, 1, Form::power);
  const auto groups = curve_statistics(set);
  ASSERT_EQ(groups.size(), 4);
  EXPECT_EQ(groups[0].curves, 2);
  EXPECT_EQ(groups[0].degree, 2);
  EXPECT_EQ(groups[0].low, -5);
  EXPECT_EQ(groups[0].high, 7);
  EXPECT_EQ(groups[0].size.median, 2);
  EXPECT_EQ(groups[0].size.largest, 7);
  EXPECT_EQ(groups[0].distance.largest, 1);
  EXPECT_EQ(groups[1].degree, 1);
  EXPECT_TRUE(std::isnan(groups[2].size.median) || std::isnan(groups[3].size.median));  // the power form
}

TEST(CurveStatistics, DegenerateCurves) {
  struct Expected {
    std::vector<double> points;
    std::size_t points_only, ends, neighbours, collinear, monotone;
  };
  for (const auto& [points, point, ends, neighbours, collinear, monotone] :
       {Expected{{1, 2, 1, 2, 1, 2}, 1, 0, 0, 0, 0},
        {{0, 0, 1, 5, 0, 0}, 0, 1, 0, 1, 0},
        {{0, 0, 0, 0, 1, 2}, 0, 0, 1, 1, 1},
        {{0, 0, 1, 2, 3, 3}, 0, 0, 0, 0, 1},
        {{0, 0, 1, 2, 3, 1}, 0, 0, 0, 0, 0},
        {{0.1, 0.1, 0.2, 0.2, 0.3, 0.3}, 0, 0, 0, 1, 1},
        {{0, 0, 1, 1e-9, 2, 0}, 0, 0, 0, 0, 0},
        {{1e308, 0, -1e308, 0, 1.5e308, 0}, 0, 0, 0, 1, 0},
        {{0, 0, 5e-324, 5e-324, 1e-323, 0}, 0, 0, 0, 0, 0}}) {
    curves::CurveSet set;
    add(set, points);
    const auto group = curve_statistics(set).front();
    EXPECT_EQ(group.points, point) << points[2];
    EXPECT_EQ(group.coincident_ends, ends) << points[2];
    EXPECT_EQ(group.coincident_neighbours, neighbours) << points[2];
    EXPECT_EQ(group.collinear, collinear) << points[2];
    EXPECT_EQ(group.monotone, monotone) << points[2];
  }
}

TEST(CurveStatistics, DistanceOverSizeIsThatOfTheOrigin) {
  curves::CurveSet set;
  for (int k = 1; k <= 100; ++k) add(set, {100.0 * k, 0, 100.0 * k + 1, 1});
  const auto group = curve_statistics(set).front();
  EXPECT_EQ(group.distance.median, 5001);
  EXPECT_EQ(group.distance.p99, 9901);
  EXPECT_EQ(group.distance.largest, 10001);
}

}  // namespace
}  // namespace bezierbench::metric
