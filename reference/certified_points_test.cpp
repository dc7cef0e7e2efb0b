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

/// Random curves, half of them with coefficients and weights of very different sizes and signs, and parameters within
/// and beyond [0, 1].
struct Trials {
  std::mt19937_64 bits{3};
  std::vector<double> coefficients;
  std::vector<double> weights;

  CurveView<double> curve(const Setting& of) {
    coefficients.clear();
    weights.clear();
    const bool wild = bits() % 2 == 0;
    for (int k = 0; k < (of.degree + 1) * of.dimension; ++k)
      coefficients.push_back(std::ldexp(2 * uniform(bits) - 1, wild ? static_cast<int>(bits() % 120) - 60 : 0));
    if (of.form == Form::rational)
      for (int i = 0; i <= of.degree; ++i)
        weights.push_back(wild ? std::ldexp(2 * uniform(bits) - 1, static_cast<int>(bits() % 20))
                               : uniform(bits) + 0.1);
    return {of.form, of.dimension, of.degree, coefficients, weights};
  }
  double t() {
    return bits() % 4 == 0 ? 16 * uniform(bits) - 8 : uniform(bits) * std::ldexp(1.0, -static_cast<int>(bits() % 4));
  }
};

const std::vector<Setting> settings{{Form::bernstein, 1, 0},  {Form::bernstein, 2, 1},  {Form::bernstein, 3, 4},
                                    {Form::bernstein, 2, 20}, {Form::bernstein, 1, 57}, {Form::bernstein, 2, 128},
                                    {Form::power, 1, 0},      {Form::power, 2, 7},      {Form::power, 3, 20},
                                    {Form::power, 1, 128},    {Form::rational, 1, 0},   {Form::rational, 2, 1},
                                    {Form::rational, 3, 5},   {Form::rational, 2, 20},  {Form::rational, 1, 100}};

/// By how many of its stated errors a certified point is off the exact one; negative where nothing is certified.
double share_of_error(CertifiedPoints& points, ExactCurve& exact, const CurveView<double>& curve, double t) {
  points.load(0, curve, t);
  points.evaluate();
  const auto point = points.point(0);
  if (!point) return -1;
  const auto& truth = exact.point(curve, t);
  EXPECT_TRUE(truth.exists());
  double largest = 0;
  for (int axis = 0; axis < curve.dimension; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    const auto off = abs(exactly(point->high[at]) + exactly(point->low[at]) - truth.coordinate(axis));
    largest = std::max(largest, reference::quotient(binary64, off, exactly(point->error)));
  }
  return largest;
}

TEST(CertifiedPoints, AreWithinTheirError) {
  Trials trials;
  ExactCurve exact;
  for (const auto& setting : settings) {
    CertifiedPoints points(setting.form, setting.dimension, setting.degree);
    double closest = -1;
    int certified = 0;
    for (int round = 0; round < 300; ++round) {
      const double share = share_of_error(points, exact, trials.curve(setting), trials.t());
      ASSERT_LE(share, 1) << setting.degree;
      closest = std::max(closest, share);
      certified += share >= 0 ? 1 : 0;
    }
    EXPECT_GT(certified, setting.degree < 100 ? 250 : 180)
        << setting.degree;  // far outside, high degrees leave the range
    EXPECT_GT(closest, setting.degree == 0 ? -1 : 1e-4) << setting.degree;
  }
}

/// Degrees whose binomials are not doubles, up to the largest of all.
TEST(CertifiedPoints, AreWithinTheirErrorAtHighDegrees) {
  Trials trials;
  ExactCurve exact;
  for (const Form form : {Form::bernstein, Form::power, Form::rational})
    for (const int degree : {300, 512, 1023}) {
      CertifiedPoints points(form, 1, degree);
      for (int round = 0; round < 8; ++round) {
        const double t = round == 0 ? 0.5 : round == 1 ? 1 - 0x1p-53 : round == 2 ? 0x1p-99 : uniform(trials.bits);
        const double share = share_of_error(points, exact, trials.curve({form, 1, degree}), t);
        ASSERT_GE(share, 0) << degree << " " << t;
        ASSERT_LE(share, 1) << degree << " " << t;
      }
    }
}

/// Coefficients of (t - root)^n over [0, 1], each rounded: next to the root all terms cancel.
std::vector<double> multiple_root(Form form, int n, double root) {
  std::vector<double> coefficients;
  for (int i = 0; i <= n; ++i) {
    double value = 1;
    for (int k = 0; k < n; ++k)
      value *= form == Form::power ? (k < n - i ? -root * (i + k + 1) / (k + 1) : 1) : (k < i ? 1 - root : -root);
    coefficients.push_back(value);
  }
  return coefficients;
}

TEST(CertifiedPoints, AreWithinTheirErrorOnHardInputs) {
  std::mt19937_64 bits(7);
  ExactCurve exact;
  const std::array parameters{0x1p-99, 0x1p-53,     0.3,         0.5 - 0x1p-54, 0.5,        0.5 + 0x1p-53,
                              0.75,    1 - 0x1p-53, 1 + 0x1p-52, 1.25,          -0x1p-60,   -0.25,
                              2.0,     8.0,         -8.0,        0.3 + 0x1p-50, 1 - 0x1p-30};
  int certified = 0;
  int asked = 0;
  for (const Form form : {Form::bernstein, Form::power, Form::rational})
    for (const int n : {1, 2, 3, 8, 21, 64}) {
      CertifiedPoints points(form, 1, n);
      const auto count = static_cast<std::size_t>(n) + 1;
      std::vector<std::vector<double>> families{multiple_root(form, n, 0.3), multiple_root(form, n, 0.5)};
      std::vector<double> tiny(count);  // subnormal numbers beside the least that is certified
      std::vector<double> wide(count);  // from 2^-1074 to the largest that is certified
      std::vector<double> alternating(count);
      for (std::size_t i = 0; i < count; ++i) {
        tiny[i] = i % 3 == 0 ? std::ldexp(uniform(bits), -598) : std::ldexp(uniform(bits), -1060);
        wide[i] = std::ldexp(2 * uniform(bits) - 1, i % 2 == 0 ? 580 : -1070 + static_cast<int>(bits() % 1600));
        alternating[i] = i % 2 == 0 ? 1 : -1;
      }
      families.insert(families.end(), {tiny, wide, alternating});
      std::vector<double> wide_weights;
      for (std::size_t i = 0; i < count; ++i)
        wide_weights.push_back(std::ldexp(uniform(bits) + 0.5, 180 - static_cast<int>(bits() % 560)));
      for (const auto& coefficients : families)
        for (const auto& weights : {std::vector<double>(count, 1.0), alternating, wide_weights})
          for (const double t : parameters) {
            const auto of_curve = form == Form::rational ? std::span<const double>(weights) : std::span<const double>();
            const double share = share_of_error(points, exact, {form, 1, n, coefficients, of_curve}, t);
            ASSERT_LE(share, 1) << name(form) << " " << n << " " << t;
            certified += share >= 0 ? 1 : 0;
            ++asked;
          }
    }
  EXPECT_GT(certified, asked / 2);
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
      const std::size_t lane = static_cast<std::size_t>(round) % CertifiedPoints::lanes;
      points.load(lane, curve, t);
      points.evaluate();
      const auto point = points.point(lane);
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
  EXPECT_FALSE(CertifiedPoints::applies(Form::power_centered));
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
  const std::vector<double> cancelling{1, -1, 1};  // weights: their sum is (1 - 2t)^2
  CertifiedPoints rational(Form::rational, 1, 2);
  for (const auto& [t, certified] : {std::pair{0.5, false}, {0.5 + 0x1p-30, false}, {0.5 + 0x1p-15, true}}) {
    rational.load(0, {Form::rational, 1, 2, plain, cancelling}, t);
    rational.evaluate();
    EXPECT_EQ(rational.point(0).has_value(), certified) << t;
  }
  for (const double weight : {0x1p-401, 0x1p+201}) {
    const std::vector<double> extreme{1, weight, 1};
    rational.load(0, {Form::rational, 1, 2, plain, extreme}, 0.25);
    rational.evaluate();
    EXPECT_FALSE(rational.point(0)) << weight;
  }
  const std::vector<double> tiny{0x1p-610, 0x1p-609, 0x1p-610};
  points.load(0, {Form::bernstein, 1, 2, tiny}, 0.5);
  points.evaluate();
  EXPECT_FALSE(points.point(0));
  // Beyond t = 1 what a step of power form loses by underflow grows up to |t|^n times.
  std::vector<double> growing(101, 0.0);
  growing.front() = 0x1p-500;
  CertifiedPoints power(Form::power, 1, 100);
  for (const auto& [t, certified] : {std::pair{0.5, true}, {8.0, false}}) {
    power.load(0, {Form::power, 1, 100, growing}, t);
    power.evaluate();
    EXPECT_EQ(power.point(0).has_value(), certified) << t;
  }
}

TEST(CertifiedPoints, EvaluateOneAsAll) {
  Trials trials;
  for (const auto& setting : settings) {
    CertifiedPoints all(setting.form, setting.dimension, setting.degree);
    CertifiedPoints one(setting.form, setting.dimension, setting.degree);
    const auto curve = trials.curve(setting);
    const double t = uniform(trials.bits);
    for (std::size_t k = 0; k < CertifiedPoints::lanes; ++k) all.load(k, curve, t);
    all.evaluate();
    one.load(0, curve, t);
    one.evaluate_one();
    ASSERT_TRUE(all.point(0) && one.point(0));
    EXPECT_EQ(all.point(0)->high, one.point(0)->high);
    EXPECT_EQ(all.point(0)->low, one.point(0)->low);
    EXPECT_EQ(all.point(0)->error, one.point(0)->error);
    for (std::size_t k = 1; k < CertifiedPoints::lanes; ++k) EXPECT_FALSE(one.point(k)) << k;
  }
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
