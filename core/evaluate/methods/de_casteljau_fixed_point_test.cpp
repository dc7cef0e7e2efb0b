// SPDX-License-Identifier: MIT
// The bound of fixed-point de Casteljau against exact arithmetic, what happens next to overflow and underflow, and what
// cheaper steps lose: each by one input. guarantees_test.cpp tries what it keeps.
#include "core/evaluate/methods/de_casteljau_fixed_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <random>
#include <span>
#include <vector>

#include "core/evaluate/kernel/kernel.hpp"
#include "core/evaluate/small_float_test.hpp"

namespace bezierbench {
namespace {

namespace mp = boost::multiprecision;
using Rational = mp::number<mp::cpp_rational_backend, mp::et_off>;
constexpr double largest_number = std::numeric_limits<double>::max();
constexpr double eta = std::numeric_limits<double>::denorm_min();
constexpr double u = 0x1p-53;

double point(const std::vector<double>& points, double t) {
  Curve<Form::bernstein, double, 1> curve(static_cast<int>(points.size()) - 1);
  for (std::size_t i = 0; i < points.size(); ++i) curve(0, static_cast<int>(i)) = points[i];
  return DeCasteljauFixedPoint::evaluate(DeCasteljauFixedPoint::prepare(curve), t)[0];
}

Rational exact_point(const std::vector<double>& points, double t) {
  std::vector<Rational> b(points.begin(), points.end());
  const Rational at(t);
  for (std::size_t count = b.size() - 1; count > 0; --count)
    for (std::size_t i = 0; i < count; ++i) b[i] += at * (b[i + 1] - b[i]);
  return b[0];
}

/// The error over u |p| + (2n+4) u (1 + 4u) (h - l) + n eta / 2.
double share_of_bound(const std::vector<double>& points, double t) {
  const Rational p = exact_point(points, t);
  const auto [least, largest] = std::ranges::minmax(points);
  const auto n = static_cast<double>(points.size() - 1);
  const Rational bound = Rational(u) * abs(p) +
                         Rational((2 * n + 4) * u * (1 + 4 * u)) * (Rational(largest) - Rational(least)) +
                         Rational(n / 2) * Rational(eta);
  const Rational error = abs(Rational(point(points, t)) - p);
  return error == 0 ? 0 : Rational(error / bound).convert_to<double>();
}

TEST(DeCasteljauFixedPoint, KeepsItsBoundAtEveryScale) {
  std::mt19937_64 random(1);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  double largest_share = 0;
  for (const int degree : {0, 1, 2, 3, 5, 10})
    for (const int exponent : {0, 1, 1024, 1021, -1000, -1022, -1060})
      for (int trial = 0; trial < 40; ++trial) {
        std::vector<double> points(static_cast<std::size_t>(degree) + 1);
        const double centre = trial % 2 == 0 ? 0 : 0.5;  // about 0, and beside it
        for (double& b : points) b = std::ldexp(centre + (uniform() - 0.5) * (trial % 3 == 0 ? 1 : 0.125), exponent);
        const double t = trial % 4 == 0 ? std::ldexp(uniform(), -20) : uniform();
        const double share = share_of_bound(points, t);
        EXPECT_LE(share, 1) << degree << ' ' << exponent << ' ' << trial;
        largest_share = std::max(largest_share, share);
      }
  EXPECT_GT(largest_share, 0.1);  // the bound is not far above
}

TEST(DeCasteljauFixedPoint, IsExactOnSubnormalNumbersWhoseCurveIs) {
  EXPECT_EQ(point({0, 4 * eta}, 0.25), eta);
  EXPECT_EQ(point({16 * eta, 0, 0}, 0.75), eta);
}

TEST(DeCasteljauFixedPoint, ReachesTheLargestNumbers) {
  const std::vector<double> across{-largest_number, largest_number, -largest_number, largest_number};
  EXPECT_EQ(point(across, 0), -largest_number);
  EXPECT_LE(share_of_bound(across, 0.5), 1);
  EXPECT_EQ(point(across, 1), largest_number);
  EXPECT_EQ(point({largest_number, largest_number}, 0x1.5555555555555p-2), largest_number);
  EXPECT_EQ(point({eta, largest_number}, 0), eta);
}

TEST(DeCasteljauFixedPoint, StaysAtTheNearerEndOutside) {
  EXPECT_EQ(point({1, 2, 5}, -1), 1);
  EXPECT_EQ(point({1, 2, 5}, 1.5), 5);
}

/// The state has room for the largest degree; writing all of it takes longer than the rest of the work for a cubic.
TEST(DeCasteljauFixedPoint, PreparesWhatTheDegreeNeedsOnly) {
  const auto& kernel = *find_kernel<double>(DeCasteljauFixedPoint::info.id, Form::bernstein, 3);
  ASSERT_GT(kernel.prepared_size, 3 * max_degree * sizeof(double));
  constexpr unsigned char untouched = 0xA5;
  void* state = ::operator new(kernel.prepared_size, std::align_val_t(kernel.prepared_alignment));
  std::memset(state, untouched, kernel.prepared_size);
  const std::vector<double> cubic{0, 1, 2, 3, 5, 8, 13, 21, 34, 55, 89, 144};
  kernel.prepare({Form::bernstein, 3, 3, cubic}, state);
  const std::span bytes(static_cast<const unsigned char*>(state), kernel.prepared_size);
  EXPECT_LT(bytes.size() - static_cast<std::size_t>(std::ranges::count(bytes, untouched)), 512U);
  ::operator delete(state, std::align_val_t(kernel.prepared_alignment));
}

template <class Scalar>
void expect_the_open_interval() {
  using Limits = std::numeric_limits<Scalar>;
  for (const Scalar t : {Limits::denorm_min(), Limits::min(), Scalar(0.5), std::nextafter(Scalar(1), Scalar(0))})
    EXPECT_TRUE(inside_unit_interval(t)) << t;
  for (const Scalar t :
       {Scalar(0), Scalar(-0.0), Scalar(1), std::nextafter(Scalar(1), Scalar(2)), Limits::max(), Limits::infinity(),
        -Limits::denorm_min(), Scalar(-0.5), -Limits::infinity(), Limits::quiet_NaN(), -Limits::quiet_NaN()})
    EXPECT_FALSE(inside_unit_interval(t)) << t;
}

TEST(InsideUnitInterval, IsDecidedByBits) {
  expect_the_open_interval<double>();
  expect_the_open_interval<float>();
}

// Cheaper steps on the numbers as they are, each bounded by its two ends. Every input is one that a search found.

using Step = double (*)(double a, double b, double t);

double triangle(Step step, std::vector<double> b, double t) {
  for (std::size_t count = b.size() - 1; count > 0; --count)
    for (std::size_t i = 0; i < count; ++i) b[i] = step(b[i], b[i + 1], t);
  return b[0];
}
double bounded(double x, double a, double b) { return std::clamp(x, std::min(a, b), std::max(a, b)); }

double convex(double a, double b, double t) { return bounded((1 - t) * a + t * b, a, b); }
double convex_fused(double a, double b, double t) { return bounded(std::fma(t, b, (1 - t) * a), a, b); }
double one_sided(double a, double b, double t) { return bounded(std::fma(t, b - a, a), a, b); }
double standard(double a, double b, double t) { return std::lerp(a, b, t); }
double two_sided(double a, double b, double t) {
  if (t == 0.5) return a / 2 + b / 2;
  return bounded(t < 0.5 ? std::fma(t, b - a, a) : std::fma(1 - t, a - b, b), a, b);
}

/// Whether ascending points give a fall from t to the next number; `fixed point` does not.
bool falls(Step step, const std::vector<double>& points, double t) {
  const double next = std::nextafter(t, 1.0);
  EXPECT_TRUE(std::ranges::is_sorted(points));
  EXPECT_LE(point(points, t), point(points, next));
  return triangle(step, points, t) > triangle(step, points, next);
}

/// Whether the reversed points give another value at 1-t, which is exact; `fixed point` does not.
bool differs_backwards(Step step, const std::vector<double>& points, double t) {
  const std::vector<double> backwards(points.rbegin(), points.rend());
  EXPECT_EQ(1 - (1 - t), t);
  EXPECT_EQ(point(points, t), point(backwards, 1 - t));
  return triangle(step, points, t) != triangle(step, backwards, 1 - t);
}

TEST(CheaperSteps, AreNotMonotone) {
  EXPECT_TRUE(falls(convex, {-1, -0.25}, 0x1.e5f85b7a988p-11));
  EXPECT_TRUE(falls(convex_fused, {-0.375, -0.0625}, 0x1.1acc46993bp-11));
  EXPECT_TRUE(falls(one_sided, {0, 0.125, 3.5}, 0x1.e03b5cb008bap-4));
  EXPECT_TRUE(falls(standard, {0, 0.25, 1}, 0x1.f74805b779af2p-1));
  EXPECT_TRUE(falls(two_sided, {-0.25, 0.5, 2}, 0x1.fffffffffffe8p-2));
}

TEST(CheaperSteps, ChangeWithTheDirection) {
  EXPECT_TRUE(differs_backwards(convex_fused, {-0.375, -0.125}, 0x1.99b97ed4c6p-14));
  EXPECT_TRUE(differs_backwards(one_sided, {-0x1.3bc0fdc45p-26, 2}, 0.375));
  EXPECT_TRUE(differs_backwards(standard, {-0.25, -7}, 0x1.311046c1p-17));
}

}  // namespace
}  // namespace bezierbench
