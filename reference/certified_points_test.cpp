// SPDX-License-Identifier: MIT
#include "reference/certified_points.hpp"

#include <gtest/gtest.h>

#include <random>

#include "reference/exact_curve.hpp"

namespace bezierbench::reference {
namespace {

double uniform(std::mt19937_64& bits) { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

struct Setting {
  Form form;
  int dimension;
  int degree;
};

/// Random curves, half of them with coefficients of very different sizes, and parameters within and beyond [0, 1].
struct Trials {
  std::mt19937_64 bits{3};
  std::vector<double> coefficients;

  CurveView<double> curve(const Setting& of) {
    coefficients.clear();
    const bool wild = bits() % 2 == 0;
    for (int k = 0; k < (of.degree + 1) * of.dimension; ++k)
      coefficients.push_back(std::ldexp(2 * uniform(bits) - 1, wild ? static_cast<int>(bits() % 120) - 60 : 0));
    return {of.form, of.dimension, of.degree, coefficients};
  }
  double t() {
    return bits() % 4 == 0 ? 16 * uniform(bits) - 8 : uniform(bits) * std::ldexp(1.0, -static_cast<int>(bits() % 4));
  }
};

const std::vector<Setting> settings{{Form::bernstein, 1, 0},  {Form::bernstein, 2, 1},  {Form::bernstein, 3, 4},
                                    {Form::bernstein, 2, 20}, {Form::bernstein, 1, 56}, {Form::power, 1, 0},
                                    {Form::power, 2, 7},      {Form::power, 3, 20},     {Form::power, 1, 128}};

TEST(CertifiedPoints, AreWithinTheirError) {
  Trials trials;
  ExactCurve exact;
  for (const auto& setting : settings) {
    CertifiedPoints points(setting.form, setting.dimension, setting.degree);
    double closest = 0;  // to the stated error
    for (int round = 0; round < 300; ++round) {
      const auto curve = trials.curve(setting);
      const double t = trials.t();
      points.load(0, curve, t);
      points.evaluate();
      const auto point = points.point(0);
      if (!point) continue;
      const auto& truth = exact.point(curve, t);
      for (int axis = 0; axis < setting.dimension; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        const auto off = abs(exactly(point->high[at]) + exactly(point->low[at]) - truth.coordinate(axis));
        const double share = reference::quotient(binary64, off, exactly(point->error));
        ASSERT_LE(share, 1) << setting.degree;
        closest = std::max(closest, share);
      }
    }
    EXPECT_GT(closest, setting.degree == 0 ? -1 : 0) << "nothing was certified";
  }
}

/// Every certified value equals that of the integers, also for points that are nearly right, and for the length.
TEST(CertifiedPoints, DistancesAreThoseOfTheIntegers) {
  Trials trials;
  ExactCurve exact;
  std::size_t certified = 0;
  std::size_t asked = 0;
  for (const auto& setting : settings) {
    CertifiedPoints points(setting.form, setting.dimension, setting.degree);
    for (int round = 0; round < 400; ++round) {
      const auto curve = trials.curve(setting);
      const double t = trials.t();
      points.load(round % CertifiedPoints::lanes, curve, t);
      points.evaluate();
      const auto point = points.point(round % CertifiedPoints::lanes);
      const auto& truth = exact.point(curve, t);
      const Distance distance(truth);
      std::vector<double> computed;
      for (int axis = 0; axis < setting.dimension; ++axis)
        computed.push_back(round_to(binary64, truth.coordinate(axis)));
      for (int step = 0; step < 4; ++step) {  // the nearest double, then ever farther; last the origin
        ++asked;
        if (point)
          if (const auto found = point->distance(computed)) {
            ++certified;
            ASSERT_EQ(*found, distance.to(computed)) << setting.degree << " " << step;
          }
        for (double& value : computed)
          value = step == 2 ? 0 : value * (1 + std::ldexp(static_cast<double>(trials.bits() % 64), -52 + 10 * step));
      }
    }
  }
  EXPECT_GT(certified, asked / 2);
}

TEST(CertifiedPoints, LeavesOutWhatIsNotProved) {
  EXPECT_FALSE(CertifiedPoints::applies(Form::bernstein, 57));
  EXPECT_FALSE(CertifiedPoints::applies(Form::power, 129));
  EXPECT_FALSE(CertifiedPoints::applies(Form::power_centered, 3));
  const std::vector<double> coefficients{1, 0x1p+700, 1};
  CertifiedPoints points(Form::bernstein, 1, 2);
  points.load(0, {Form::bernstein, 1, 2, coefficients}, 0.5);
  points.evaluate();
  EXPECT_FALSE(points.point(0));  // a coefficient out of range
  const std::vector<double> plain{1, 2, 1};
  for (const double t : {0.0, 0x1p-200, 9.0}) {
    points.load(0, {Form::bernstein, 1, 2, plain}, t);
    points.evaluate();
    EXPECT_FALSE(points.point(0)) << t;
  }
  points.load(0, {Form::bernstein, 1, 2, plain}, 0.5);
  points.evaluate();
  const auto point = points.point(0);
  ASSERT_TRUE(point);
  EXPECT_FALSE(point->distance(std::vector<double>{1.5}));  // exactly right: no error bound proves zero
  EXPECT_TRUE(point->distance(std::vector<double>{1.25}));
  const std::vector<double> tiny{0x1p-610, 0x1p-609, 0x1p-610};
  points.load(0, {Form::bernstein, 1, 2, tiny}, 0.5);
  points.evaluate();
  EXPECT_FALSE(points.point(0));
}

/// Points whose distances take every path: near, far, the point itself, on one axis only, tiny, huge, NaN.
std::vector<double> any_point(const CertifiedPoint& from, std::size_t kind, std::mt19937_64& bits) {
  std::vector<double> point;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(from.dimension); ++axis) {
    const double near = from.high[axis] * (1 + std::ldexp(uniform(bits) - 0.5, -static_cast<int>(bits() % 50)));
    const std::array<double, 8> choices{near,
                                        from.high[axis],
                                        0,
                                        axis == 0 ? near : from.high[axis],
                                        uniform(bits),
                                        1e290,
                                        from.high[axis],
                                        std::numeric_limits<double>::quiet_NaN()};
    point.push_back(choices[kind % choices.size()]);
  }
  return point;
}

TEST(CertifiedBlock, HasTheDistancesOfItsPoints) {
  Trials trials;
  int proved = 0;
  int unproved = 0;
  for (const auto& setting : settings)
    for (int round = 0; round < 100; ++round) {
      CertifiedPoints points(setting.form, setting.dimension, setting.degree);
      for (std::size_t k = 0; k < CertifiedPoints::lanes; ++k) points.load(k, trials.curve(setting), trials.t());
      points.evaluate();
      PointLanes asked{};
      std::array<std::optional<double>, CertifiedPoints::lanes> right;
      for (std::size_t k = 0; k < CertifiedPoints::lanes; ++k) {
        const auto from = points.point(k);
        EXPECT_EQ(from.has_value(), !std::isnan(points.points().error[k]));
        if (!from) continue;
        const auto point = any_point(*from, k, trials.bits);
        for (std::size_t axis = 0; axis < point.size(); ++axis) asked[axis][k] = point[axis];
        right[k] = from->distance(point);
      }
      const auto ours = points.points().distances(asked);
      for (std::size_t k = 0; k < CertifiedPoints::lanes; ++k) {
        ASSERT_EQ(!std::isnan(ours[k]), right[k].has_value());
        if (right[k]) {
          ASSERT_EQ(ours[k], *right[k]);
        }
        ++(right[k] ? proved : unproved);
      }
    }
  EXPECT_GT(proved, 1000);
  EXPECT_GT(unproved, 1000);
}

/// A baseline's point has no error of its own.
TEST(CertifiedBlock, MeasuresFromPointsThatAreExact) {
  std::mt19937_64 bits(5);
  int proved = 0;
  for (int round = 0; round < 100; ++round) {
    CertifiedBlock from;
    PointLanes to{};
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t k = 0; k < certified_lanes; ++k) {
        from.high[axis][k] = uniform(bits);
        to[axis][k] = from.high[axis][k] + std::ldexp(uniform(bits), -static_cast<int>(bits() % 60));
      }
    const auto ours = from.distances(to);
    for (std::size_t k = 0; k < certified_lanes; ++k) {
      const std::array<double, 2> a{from.high[0][k], from.high[1][k]};
      const std::array<double, 2> b{to[0][k], to[1][k]};
      if (!std::isnan(ours[k])) {
        EXPECT_EQ(ours[k], distance(exactly(a), exactly(b)));
        ++proved;
      }
    }
  }
  EXPECT_GT(proved, 1500);  // of 1600
}

}  // namespace
}  // namespace bezierbench::reference
