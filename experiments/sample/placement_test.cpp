// SPDX-License-Identifier: MIT
#include "experiments/sample/placement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace bezierbench::sample {
namespace {

const Placement& find(std::string_view id) {
  return *std::ranges::find_if(placements(), [id](const Placement& one) { return one.id == id; });
}

ProjectionCase placed(std::string_view id, int degree, int dimension, std::uint64_t trial) {
  Cell cell;
  cell.degree = degree;
  cell.dimension = dimension;
  cell.coordinate_range = 100;
  return place(find(id), Sampler(1, "placement", with_point(cell)), cell, trial);
}

double x(const ProjectionCase& problem, int i, int axis) {
  return problem.points[static_cast<std::size_t>(i * problem.dimension + axis)];
}

TEST(Placement, DrawsTheSameCurveWhereItMovesOnlyThePoint) {
  const auto uniform = placed("uniform", 4, 3, 7);
  EXPECT_EQ(uniform.points.size(), 15U);
  EXPECT_EQ(uniform.point.size(), 3U);
  for (const char* id : {"on_curve", "beside", "centre"}) {
    EXPECT_EQ(placed(id, 4, 3, 7).points, uniform.points) << id;
    EXPECT_NE(placed(id, 4, 3, 7).point, uniform.point) << id;
  }
}

/// A cusp of degree 60 needs a control point at about 2^59 R, and a lattice of 5e-324 / 2^20 does not exist.
TEST(Placement, KeepsWhatIsDrawnWhereAPlacementLeavesTheRange) {
  for (const double range : {0x1p+1020, 5e-324})
    for (const auto& placement : placements()) {
      Cell cell;
      cell.degree = 60;
      cell.coordinate_range = range;
      const auto problem = place(placement, Sampler(1, "placement", with_point(cell)), cell, 1);
      for (const auto* values : {&problem.points, &problem.point})
        for (const double value : *values) EXPECT_TRUE(std::isfinite(value)) << placement.id << ", R " << range;
    }
}

/// The first equation says that C'(1/2) = 0 for a cubic, exactly.
TEST(Placement, ACuspStandsStill) {
  for (std::uint64_t trial = 0; trial < 50; ++trial) {
    const auto problem = placed("cusp", 3, 2, trial);
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_EQ(x(problem, 3, axis) + x(problem, 2, axis), x(problem, 1, axis) + x(problem, 0, axis));
      EXPECT_EQ(problem.point[static_cast<std::size_t>(axis)],
                (x(problem, 0, axis) + 3 * x(problem, 1, axis) + 3 * x(problem, 2, axis) + x(problem, 3, axis)) / 8);
    }
  }
}

TEST(Placement, MirrorsTheCurve) {
  for (const int n : {2, 3, 6}) {
    const auto problem = placed("mirrored", n, 2, 3);
    EXPECT_EQ(problem.point[0], 0);
    for (int i = 0; i <= n; ++i) {
      EXPECT_EQ(x(problem, i, 0), -x(problem, n - i, 0));
      EXPECT_EQ(x(problem, i, 1), x(problem, n - i, 1));
    }
  }
}

/// At the centre of curvature (C - P).C' has a double root: q.C' = 0 and |C'|^2 + q.C'' = 0 with q = C - P.
TEST(Placement, FindsTheCentreOfCurvature) {
  ProjectionCase parabola{2, 2, {0, 0, 1, 0, 2, 2}, {9, 9}};  // (u, u^2 / 2), u = 2t: radius 1 at its vertex
  find("centre").place(parabola, 0);
  EXPECT_EQ(parabola.point, (std::vector<double>{0, 1}));
}

TEST(Placement, DividesALineEvenly) {
  const auto problem = placed("line", 4, 1, 2);
  for (int i = 0; i <= 4; ++i)
    EXPECT_NEAR(x(problem, i, 0), (x(problem, 0, 0) * (4 - i) + x(problem, 4, 0) * i) / 4, 1e-13);
}

}  // namespace
}  // namespace bezierbench::sample
