// SPDX-License-Identifier: MIT
#include "experiments/sample/placement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/sample/data_kind.hpp"
#include "experiments/sample/knot_kind.hpp"

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
  ProjectionCase parabola{2, 2, {0, 0, 1, 0, 2, 2}, {9, 9}, {}};  // (u, u^2 / 2), u = 2t: radius 1 at its vertex
  find("centre").place(parabola, 0);
  EXPECT_EQ(parabola.point, (std::vector<double>{0, 1}));
}

TEST(Placement, DividesALineEvenly) {
  const auto problem = placed("line", 4, 1, 2);
  for (int i = 0; i <= 4; ++i)
    EXPECT_NEAR(x(problem, i, 0), (x(problem, 0, 0) * (4 - i) + x(problem, 4, 0) * i) / 4, 1e-13);
}

}  // namespace

namespace {

std::vector<double> made(std::string_view id, DataSource source) {
  return std::ranges::find_if(data_kinds(), [id](const DataKind& kind) { return kind.id == id; })
      ->make(std::move(source));
}

const DataSource parabola{2, 2, {0, 0, 1, 2, 2, 0}, {8, 0, -8, 8, 0, 0, 8, 0, 4, 0}};  // (2t, 4t(1-t)), five points

TEST(DataKinds, AreMadeOfTheCurve) {
  using testing::ElementsAre;
  EXPECT_THAT(made("samples", parabola), ElementsAre(0, 0, 0.5, 0.75, 1, 1, 1.5, 0.75, 2, 0));
  // t = 0, 0.2, 0.5, 0.8, 1
  EXPECT_THAT(
      made("uneven", parabola),
      testing::Pointwise(testing::DoubleNear(1e-15), std::vector<double>{0, 0, 0.4, 0.64, 1, 1, 1.6, 0.64, 2, 0}));
  EXPECT_THAT(made("noisy", parabola),
              ElementsAre(0x1p-7, 0, 0.5 - 0x1p-7, 0.75 + 0x1p-7, 1, 1, 1.5 + 0x1p-7, 0.75, 2 + 0x1p-8, 0));
  EXPECT_THAT(made("polyline", parabola), ElementsAre(0, 0, 0.5, 1, 1, 2, 1.5, 1, 2, 0));
  EXPECT_THAT(made("closed", parabola), ElementsAre(0, 0, 0.375, 0.75, 0.5, 1, 0.375, 0.75, 0, 0));
}

TEST(DataKinds, PolylineKeepsItsVertices) {
  for (std::size_t count = 2; count < 30; ++count) {
    const auto data = made("polyline", {1, 4, {0, 1, 3, -4, 7}, std::vector<double>(count, 0.0)});
    ASSERT_EQ(data.size(), count);
    for (const double vertex : {0, 1, 3, -4, 7}) {
      if (count >= 5) {
        EXPECT_THAT(data, testing::Contains(vertex)) << count;
      }
    }
  }
}

TEST(DataKinds, AClosedCubicIsALoop) {
  const auto data = made("closed", {2, 3, {0, 0, 6, 0, 0, 6, 9, 9}, std::vector<double>(10, 0.0)});
  EXPECT_THAT(data, testing::ElementsAre(0, 0, 2.53125, 0.84375, 2.25, 2.25, 0.84375, 2.53125, 0, 0));
}

TEST(DataKinds, OfACellAreDrawnFromItsCurve) {
  Cell cell;
  cell.degree = 3;
  const Sampler sampler(1, "data", with_displacements(cell, 20));
  Trial drawn;
  sampler.draw(5, drawn);
  for (const auto& kind : data_kinds()) {
    const auto data = data_points(kind, sampler, cell, 5);
    ASSERT_EQ(data.size(), 40U) << kind.id;
    EXPECT_NEAR(data[0], drawn.coefficients[0], 0x1p-9) << kind.id;
  }
}

}  // namespace

namespace {

std::vector<double> drawn(std::string_view id, int degree, std::uint64_t trial) {
  Words words(1, 2, 3, trial);
  return draw_knots(*std::ranges::find(knot_kinds(), id, &KnotKind::id), degree, words);
}

/// The number of knots that are equal to the one at `place`.
std::ptrdiff_t multiplicity(const std::vector<double>& knots, std::size_t place) {
  return std::ranges::count(knots, knots[place]);
}

TEST(KnotKinds, AscendAndLeaveASpan) {
  for (const auto& kind : knot_kinds())
    for (const int degree : {1, 2, 5, 20, 200})
      for (std::uint64_t trial = 0; trial < 50; ++trial) {
        const auto knots = drawn(kind.id, degree, trial);
        ASSERT_EQ(knots.size(), 2 * static_cast<std::size_t>(degree)) << kind.id;
        EXPECT_TRUE(std::ranges::is_sorted(knots)) << kind.id;
        EXPECT_LT(knots[knots.size() / 2 - 1], knots[knots.size() / 2]) << kind.id;
      }
}

TEST(KnotKinds, AreWhatTheirNamesSay) {
  int threefold = 0;
  double widest = 0;
  double narrowest = 1;
  for (std::uint64_t trial = 0; trial < 100; ++trial) {
    const auto uniform = drawn("uniform", 3, trial);
    EXPECT_EQ(uniform[2], std::floor(uniform[2]));
    for (std::size_t k = 1; k < uniform.size(); ++k) EXPECT_EQ(uniform[k] - uniform[k - 1], 1);
    const auto clamped = drawn("clamped", 3, trial);
    EXPECT_EQ(multiplicity(clamped, 0), 3);
    EXPECT_EQ(multiplicity(clamped, 3), 1);
    EXPECT_EQ(multiplicity(drawn("random", 3, trial), 2), 1);
    if (multiplicity(drawn("multiple", 3, trial), 3) == 3) ++threefold;
    const auto uneven = drawn("uneven", 3, trial);
    for (std::size_t k = 1; k < uneven.size(); ++k) {
      widest = std::max(widest, uneven[k] - uneven[k - 1]);
      narrowest = std::min(narrowest, uneven[k] - uneven[k - 1]);
    }
  }
  EXPECT_GT(threefold, 10) << "a quarter of the cases";
  EXPECT_LT(threefold, 50);
  EXPECT_GT(widest, 0.25);
  EXPECT_LT(narrowest, 0x1p-38);
}

}  // namespace

}  // namespace bezierbench::sample
