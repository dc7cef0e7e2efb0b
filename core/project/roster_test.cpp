// SPDX-License-Identifier: MIT
// Known answers for every projector, then properties over the roster.
#include "core/project/roster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/evaluate/evaluation_test.hpp"
#include "core/project/kernel.hpp"

namespace bezierbench {
namespace {

const ProjectionKernel& find(std::string_view id, int dimension = 2) {
  for (const auto& kernel : projection_kernels(dimension))
    if (kernel.info->id == id) return kernel;
  throw std::invalid_argument(std::string(id));
}

std::vector<ProjectionKernel> methods_of_polynomials(int dimension) {
  std::vector<ProjectionKernel> methods;
  for (const auto& kernel : projection_kernels(dimension))
    if (kernel.info->form == Form::bernstein) methods.push_back(kernel);
  return methods;
}

FootPoint project(std::string_view id, const std::vector<double>& points, const std::vector<double>& point) {
  const int d = static_cast<int>(point.size());
  const CurveView<double> curve{Form::bernstein, d, static_cast<int>(points.size()) / d - 1, points};
  return find(id, d).project(curve, point);
}

/// The methods that look for the global minimum.
const std::vector<std::string> global{"quintic_isolate", "quintic_companion", "quintic_durand_kerner",
                                      "quintic_jenkins_traub", "subdivide_hull"};
struct Known {
  std::vector<double> points;
  std::vector<double> point;
  double t;
  double distance;
};

/// Computed with exact integers to the digits given; these cases show the errors of [Document 002] and [Document 004].
const std::vector<Known> known{
    {{0, 0, 0, 1, 1, 1, 1, 0}, {0.5, 0}, 0, 0.5},  // both ends; the middle is 3/4 away
    {{6, 3, 5, 6, -7, -2, 7, 4}, {5, 3}, 0.945677, 0.15324},
    {{8, 5, -4, 0, 6, 3, 9, 7}, {6, 4}, 0.064530, 0.141664},
};

TEST(Projection, FindsTheFootPointsThatSearchesMiss) {
  for (const auto& [points, point, t, distance] : known)
    for (const auto& id : global) {
      const auto foot = project(id, points, point);
      EXPECT_NEAR(foot.distance, distance, 5e-6) << id << " " << distance;
      EXPECT_NEAR(foot.t, t, 5e-7) << id;
      EXPECT_TRUE(foot.converged);
    }
}

TEST(Projection, ScanningFindsOneLocalMinimum) {
  const auto& [points, point, t, distance] = known[2];
  EXPECT_NEAR(project("scan_bisect", points, point).t, 0.7459, 1e-4);  // the document's own e

  EXPECT_NEAR(project("scan_bisect", points, point).distance, 0.3085, 1e-4);
  EXPECT_NEAR(project("seed_004_scan", points, point).t, 0.7459, 2e-4);
}

/// With the printed tolerance a point on the curve is up to 1e-4 of the parameter away: on a line of length 1, where
/// the halves of 2/25 are compared down to 2/25/2^10 = 7.8e-5.
TEST(SourceDocument, PrintedToleranceLosesDigits) {
  const std::vector<double> line{0, 1};
  double largest = 0;
  for (int k = 0; k <= 1000; ++k) {
    const auto foot = project("seed_004_scan", line, {k / 1000.0});
    EXPECT_LE(std::abs(foot.t - k / 1000.0), 1e-4) << k;
    largest = std::max(largest, foot.distance);
    EXPECT_LE(project("scan_bisect", line, {k / 1000.0}).distance, 0x1p-52) << k;
  }
  EXPECT_GT(largest, 2e-5);
}

/// The nearest point, at t = 0.945677 and 0.15324 away, is in [15/16, 1], whose vertices are all farther away than
/// those of another piece. What the pruning keeps is 0.680 away at best.
TEST(SourceDocument, PruningByVerticesLosesTheNearestPoint) {
  const auto& [points, point, t, distance] = known[1];
  const auto foot = project("seed_004_subdivide", points, point);
  EXPECT_TRUE(foot.converged);
  EXPECT_NEAR(foot.distance, 0.680, 5e-4);
}

std::vector<double> coefficients_with_roots(const std::vector<double>& roots) {
  std::vector<double> f{1};
  for (const double root : roots) {
    f.push_back(0);
    for (std::size_t j = f.size(); j-- > 0;) f[j] = (j > 0 ? f[j - 1] : 0) - root * f[j];
  }
  for (double& coefficient : f) coefficient *= -24;
  return f;
}

/// Roots in [0, 1], of one binade and not, single and multiple, beside others. A k-fold root has an error of the k-th
/// root of u.
TEST(RootSolvers, FindTheRootsOfAPolynomial) {
  for (const auto& [roots, error] :
       std::vector<std::pair<std::vector<double>, double>>{{{0.5}, 0},
                                                           {{0.25, 0.75}, 1e-15},
                                                           {{0, 1}, 1e-15},
                                                           {{0.125, 0.25, 0.5, 0.75, 1}, 1e-13},
                                                           {{0.1, 0.11, 0.5, -3, 40}, 1e-12},
                                                           {{0x1p-20, 0x1p-10, 1, 1024, -0x1p20}, 1e-13},
                                                           {{0.5, 0.5, 0.25}, 1e-7},
                                                           {{0.5, 0.5, 0.5}, 1e-4},
                                                           {{-1, -2, 3, 4, 5}, 0}})
    for (const auto& solver : {QuinticDurandKerner::roots, QuinticJenkinsTraub::roots}) {
      const auto found = solver(coefficients_with_roots(roots));
      EXPECT_TRUE(found.converged);
      for (const double root : roots) {
        if (root < 0 || root > 1) continue;
        double nearest = 1;
        for (const double t : found.t) nearest = std::min(nearest, std::abs(t - root));
        if (root > 0 && root < 1) {
          EXPECT_LE(nearest, error) << root;
        }
      }
      for (const double t : found.t) {  // nothing else, but a root of the other sign that rounding made complex
        double nearest = 1;
        for (const double root : roots) nearest = std::min(nearest, std::abs(t - root));
        EXPECT_LE(nearest, std::max(error, 1e-15)) << t;
      }
    }
}

/// Complex roots: t^4 + 1 and t^4 - 1 have real parts of 1/sqrt(2) and 0.
TEST(RootSolvers, ReturnRealPartsOfComplexRoots) {
  for (const auto& solver : {QuinticDurandKerner::roots, QuinticJenkinsTraub::roots}) {
    EXPECT_THAT(solver({1, 0, 0, 0, 1}).t, testing::ElementsAre(testing::DoubleNear(std::sqrt(0.5), 1e-15),
                                                                testing::DoubleNear(std::sqrt(0.5), 1e-15)));
    EXPECT_TRUE(solver({}).t.empty());
    EXPECT_TRUE(solver({3}).t.empty());
  }
}

TEST(QuinticSeed002, PrintsWrongCoefficients) {
  const auto both = [](const std::vector<double>& points, double x, double y) {
    Curve<Form::bernstein, double, 2> curve(3);
    for (int i = 0; i <= 3; ++i)
      for (int axis = 0; axis < 2; ++axis) curve(axis, i) = points[static_cast<std::size_t>(2 * i + axis)];
    const OffsetCurve<2> offset(curve, Point<double, 2>(x, y));
    auto right = QuinticCompanion::coefficients(offset);
    auto printed = QuinticSeed002::coefficients(offset);
    const double square = std::ldexp(1.0, 2 * std::ilogb(offset.distance(0) / offset.scaled_distance(0)));
    for (auto* f : {&right, &printed})
      for (double& coefficient : *f) coefficient *= square;
    return std::pair{right, printed};
  };
  const auto [right, printed] = both(known[0].points, 0.5, 0);
  EXPECT_THAT(right, testing::ElementsAre(0, 2, -8, 12, -10, 4));
  EXPECT_THAT(printed, testing::ElementsAre(0, 2, 1, 6, 6, 4));
  const auto [flat, flat_printed] = both({0, 0, 1, 0, 2, 1, 3, 3}, 1, 1);
  EXPECT_EQ(flat[2], 0);
  EXPECT_EQ(flat_printed[2], 3);
}

TEST(QuinticSeed002, MissesFootPoints) {
  Inputs inputs(2);
  int missed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> points;
    for (int k = 0; k < 8; ++k) points.push_back(std::floor(inputs.symmetric() * 10));
    const std::vector<double> point{std::floor(inputs.symmetric() * 10), std::floor(inputs.symmetric() * 10)};
    const double excess =
        project("quintic_seed_002", points, point).distance - project("quintic_isolate", points, point).distance;
    EXPECT_GE(excess, -1e-13);
    missed += excess > 1e-3 ? 1 : 0;
  }
  EXPECT_GT(missed, 50);
}

/// f has five roots. With both ends, a method that finds all of them has seven candidates.
TEST(Projection, FindsFiveInteriorCriticalPoints) {
  const std::vector<double> points{-3, 1, 4, -7, -4, 7, 3, -1};
  EXPECT_EQ(project("quintic_isolate", points, {0, 0}).candidates, 7);
  for (const auto* id : {"quintic_companion", "quintic_durand_kerner", "quintic_jenkins_traub"}) {
    EXPECT_EQ(project(id, points, {0, 0}).candidates, 7) << id;
    EXPECT_NEAR(project(id, points, {0, 0}).distance, 0, 1e-11) << id;
  }
  EXPECT_EQ(project("quintic_isolate", points, {0, 0}).distance, 0);  // at t = 1/2
  EXPECT_EQ(project("subdivide_hull", points, {0, 0}).distance, 0);
}

/// [Document 004] takes a t with d' = 0 and d'' >= 0 for a minimum of the distance. C = 1 + (t - 1/2)^3 has d' = d'' =
/// 0 at t = 1/2, where its distance from 0, which rises all the way, has an inflection. Its nearest point is at t = 0.
TEST(SourceDocument, AnInflectionOfTheDistanceIsNoMinimum) {
  const std::vector<double> points{7.0 / 8, 9.0 / 8, 7.0 / 8, 9.0 / 8};
  for (const auto& id : global) {
    EXPECT_EQ(project(id, points, {0}).t, 0) << id;
    EXPECT_EQ(project(id, points, {0}).distance, 7.0 / 8) << id;
  }
}

/// Straight lines at constant speed in any degree: the leading coefficients of f vanish.
TEST(Projection, OntoALineOfAnyDegree) {
  for (const int n : {1, 2, 3, 5, 8})
    for (const auto& kernel : methods_of_polynomials(2)) {
      if (!kernel.info->supports<double>(n) || kernel.info->id == "quintic_seed_002" ||
          kernel.info->id == "seed_004_scan")
        continue;
      std::vector<double> points;
      for (int i = 0; i <= n; ++i) points.insert(points.end(), {4.0 * i, 8.0 * i});
      const CurveView<double> curve{Form::bernstein, 2, n, points};
      const std::vector<double> above{n - 2.0, 2.0 * n + 1};  // (-2, 1) away from the point at t = 1/4
      const auto foot = kernel.project(curve, above);
      EXPECT_NEAR(foot.t, 0.25, 1e-7) << kernel.info->id << " " << n;
      EXPECT_NEAR(foot.distance, std::sqrt(5.0), 1e-13 * n) << kernel.info->id << " " << n;
      const std::vector<double> behind{-3, -4};
      EXPECT_LT(kernel.project(curve, behind).t, 0x1p-24) << kernel.info->id;
      EXPECT_NEAR(kernel.project(curve, behind).distance, 5, 1e-6) << kernel.info->id;
    }
}

TEST(Projection, OntoACurveThatIsAPoint) {
  for (const auto& kernel : methods_of_polynomials(3)) {
    const std::vector<double> points{1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3};
    const auto foot = kernel.project({Form::bernstein, 3, 3, points}, std::vector<double>{3, 4, 4});
    EXPECT_EQ(foot.distance, 3) << kernel.info->id;
    EXPECT_EQ(kernel.project({Form::bernstein, 3, 3, points}, std::vector<double>{1, 2, 3}).distance, 0);
  }
}

/// A cubic with a cusp at t = 1/2, and the point at the cusp: f has a triple root.
TEST(Projection, AtACusp) {
  const std::vector<double> points{0, 0, 1, 1, 0, 1, 1, 0};  // C'(1/2) = 0: 3/4 (1,1) + ... = (0,0)
  const auto foot = project("quintic_isolate", points, {0.5, 0.75});
  EXPECT_LE(foot.distance, 0x1p-52);
  EXPECT_LE(project("subdivide_hull", points, {0.5, 0.75}).distance, 0x1p-52);
  EXPECT_NEAR(project("quintic_companion", points, {0.5, 0.75}).distance, 0, 1e-9);
}

/// A power of two scales every operation of all methods exactly, also where squares would overflow or underflow.
TEST(Projection, ScalesWithTheCurve) {
  Inputs inputs(3);
  for (const int d : {1, 2, 3})
    for (const int n : {3, 4}) {
      const auto points = inputs.coefficients(n, d);
      const auto point = inputs.coefficients(0, d);
      for (const double factor : {0x1p-990, 0x1p+1000}) {
        auto scaled = points;
        auto scaled_point = point;
        for (double& value : scaled) value *= factor;
        for (double& value : scaled_point) value *= factor;
        for (const auto& kernel : methods_of_polynomials(d)) {
          if (!kernel.info->supports<double>(n)) continue;
          const auto one = kernel.project({Form::bernstein, d, n, points}, point);
          const auto other = kernel.project({Form::bernstein, d, n, scaled}, scaled_point);
          EXPECT_EQ(one.t, other.t) << kernel.info->id;
          EXPECT_EQ(one.distance * factor, other.distance) << kernel.info->id;
        }
      }
    }
}

/// The same down to subnormal coordinates, which have few enough digits to be scaled exactly.
TEST(Projection, OfTheTiniestCurves) {
  Inputs inputs(5);
  for (int trial = 0; trial < 50; ++trial) {
    auto points = inputs.coefficients(3, 2);
    auto point = inputs.coefficients(0, 2);
    for (auto* values : {&points, &point})
      for (double& value : *values) value = std::floor(value * 64);
    auto tiny = points;
    auto tiny_point = point;
    for (auto* values : {&tiny, &tiny_point})
      for (double& value : *values) value *= 0x1p-1074;
    for (const auto& kernel : methods_of_polynomials(2)) {
      const auto one = kernel.project({Form::bernstein, 2, 3, points}, point);
      const auto other = kernel.project({Form::bernstein, 2, 3, tiny}, tiny_point);
      EXPECT_EQ(one.t, other.t) << kernel.info->id;
      EXPECT_EQ(std::ldexp(one.distance, -1074), other.distance) << kernel.info->id;
    }
  }
}

/// No method may find a point that is nearer than isolation's by more than rounding errors.
TEST(Projection, NoMethodFindsANearerPointThanIsolation) {
  Inputs inputs(4);
  for (int trial = 0; trial < 3000; ++trial) {
    const int d = 1 + trial % 3;
    const int n = 1 + trial % 7;
    const auto points = inputs.coefficients(n, d);
    const auto point = inputs.coefficients(0, d);
    const CurveView<double> curve{Form::bernstein, d, n, points};
    const auto isolated = find("quintic_isolate", d).project(curve, point);
    EXPECT_TRUE(isolated.converged);
    for (const auto& kernel : methods_of_polynomials(d)) {
      if (!kernel.info->supports<double>(n)) continue;
      const auto foot = kernel.project(curve, point);
      EXPECT_GE(foot.distance, isolated.distance - 4 * 0x1p-52) << kernel.info->id << " trial " << trial;
      if (kernel.info->id == "subdivide_hull") {
        EXPECT_LE(foot.distance, isolated.distance + 4 * 0x1p-52) << "trial " << trial;
      }
    }
  }
}

}  // namespace
}  // namespace bezierbench
