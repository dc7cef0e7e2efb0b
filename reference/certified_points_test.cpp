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

/// Whatever is certified is what the integers say, also for points that are nearly right, and for the length.
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

}  // namespace
}  // namespace bezierbench::reference
