// SPDX-License-Identifier: MIT
#include "reference/length/true_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace bezierbench::reference {
namespace {

TrueLength length_of(const std::vector<double>& points, int dimension, double from = 0, double to = 1) {
  return {{Form::bernstein, dimension, static_cast<int>(points.size()) / dimension - 1, points}, from, to};
}

void expect_digits(const TrueLength& length, const LongReal& expected) {
  EXPECT_LE(abs(length.value() - expected), expected * LongReal("1e-32")) << length.decimal(40);
}

TEST(TrueLength, IsTheKnownOneToThirtyTwoDigits) {
  const LongReal root13 = sqrt(LongReal(13));
  const LongReal root5 = sqrt(LongReal(5));
  expect_digits(length_of({1, 2, 4, 6}, 2), 5);
  expect_digits(length_of({0, 1, 0}, 1), 1);
  expect_digits(length_of({0, 2, -1}, 1), LongReal(13) / 5);  // turns at 2/5
  expect_digits(length_of({0, 0, 0.5, 0, 1, 1}, 2), root5 / 2 + log(2 + root5) / 4);
  // (3 t^2, 3 t^3): a cusp at the beginning
  expect_digits(length_of({0, 0, 0, 0, 1, 0, 3, 3}, 2), (13 * root13 - 8) / 9);
  // 3 (u^2, u^3), u = 2t - 1: a cusp in the middle
  expect_digits(length_of({3, -3, -1, 3, -1, -3, 3, 3}, 2), (13 * root13 - 8) * 2 / 9);
  // its part from u = -1/2 to 3/4
  const auto from_cusp = [](const LongReal& u) { return (pow(4 + 9 * u * u, LongReal(1.5)) - 8) / 9; };
  expect_digits(length_of({3, -3, -1, 3, -1, -3, 3, 3}, 2, 0.25, 0.875), from_cusp(0.5) + from_cusp(0.75));
}

/// Turns and cusps next to the end of a panel, nearer than every node of a quadrature rule: (u^2) on a line and
/// 3 (u^2, u^3) in the plane, u = t - k, with exact control points.
TEST(TrueLength, SeesATurnThatNoNodeSees) {
  const auto from_cusp = [](const LongReal& u) { return (pow(4 + 9 * u * u, LongReal(1.5)) - 8) / 9; };
  for (int level = 1; level < 10; ++level)
    for (const double beside : {1 + 0x1p-11, 1 - 0x1p-12}) {
      const double k = std::ldexp(beside, -level);
      const double w = 1 - k;
      expect_digits(length_of({k * k, k * k - k, w * w}, 1), LongReal(k) * k + LongReal(w) * w);
      if (level > 3) continue;  // beyond, the control points are rounded
      const auto cusp = length_of({3 * k * k, -3 * k * k * k, 3 * k * k - 2 * k, 3 * k * k * w, 3 * k * k - 4 * k + 1,
                                   -3 * k * w * w, 3 * w * w, 3 * w * w * w},
                                  2);
      expect_digits(cusp, from_cusp(k) + from_cusp(w));
    }
}

TrueLength length_of(const std::vector<double>& points, const std::vector<double>& weights, int dimension,
                     double from = 0, double to = 1) {
  return {{Form::rational, dimension, static_cast<int>(weights.size()) - 1, points, weights}, from, to};
}

/// The circle ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)) has the angle 2 atan(t).
TEST(TrueLength, OfRationalCurvesIsTheKnownOne) {
  const LongReal pi = acos(LongReal(-1));
  const std::vector<double> quarter{1, 0, 1, 1, 0, 1};
  expect_digits(length_of(quarter, {1, 1, 2}, 2), pi / 2);
  expect_digits(length_of(quarter, {-0x1p-80, -0x1p-80, -0x1p-79}, 2), pi / 2);
  expect_digits(length_of(quarter, {1, 1, 2}, 2, 0.25, 0.875), 2 * (atan(LongReal(0.875)) - atan(LongReal(0.25))));
  expect_digits(length_of({1 + 0x1p+40, 0, 1 + 0x1p+40, 1, 0x1p+40, 1}, {1, 1, 2}, 2), pi / 2);
  expect_digits(length_of({0x1p-600, 0, 0x1p-600, 0x1p-600, 0, 0x1p-600}, {1, 1, 2}, 2), ldexp(pi / 2, -600));
  // A line that does not turn, whatever its weights, and lines that do.
  expect_digits(length_of({0, 1, 3, 5}, {1, 0x1p+20, 0x1p-20, 8}, 1), 5);
  expect_digits(length_of({0, 1, 0}, {1, 1, 1}, 1), 1);
  EXPECT_EQ(length_of({2, 2, 2}, {1, -0.5, 1}, 1).value(), 0);
  // 1 / (1 - t + t^2) rises from 1 to 4/3 at 1/2 and falls again; its weights are 1, 1/2, 1 and its points 1, 2, 1.
  expect_digits(length_of({1, 2, 1}, {1, 0.5, 1}, 1), LongReal(2) / 3);
  // 1 / (1 - 3t + 3t^2), with weights 1, -1/2, 1: from 1 to 4 and back.
  expect_digits(length_of({1, -2, 1}, {1, -0.5, 1}, 1), 6);
}

/// Parts add up. Weights times powers of c^i are another parameter t / (t + (1 - t) / c) of the same curve.
TEST(TrueLength, OfARationalCurveDoesNotDependOnItsSpeed) {
  std::mt19937_64 words(3);
  const auto uniform = [&words] { return static_cast<double>(words() >> 11U) * 0x1p-53; };
  for (const int n : {1, 2, 3, 5, 8}) {
    std::vector<double> points;
    std::vector<double> weights;
    std::vector<double> faster;
    for (int i = 0; i <= n; ++i) {
      for (int axis = 0; axis < 3; ++axis) points.push_back(2 * uniform() - 1);
      weights.push_back(uniform() + 0.25);
      faster.push_back(std::ldexp(weights.back(), 3 * i));
    }
    const auto whole = length_of(points, weights, 3);
    expect_digits(length_of(points, faster, 3), whole.value());
    expect_digits(whole,
                  length_of(points, weights, 3, 0, 0.375).value() + length_of(points, weights, 3, 0.375, 1).value());
    EXPECT_GT(whole.value(), 0);
  }
}

TEST(TrueLength, OfAPointIsZero) {
  EXPECT_EQ(length_of({0.1, 0.2}, 2).value(), 0);
  EXPECT_EQ(length_of({0.1, 0.2, 0.1, 0.2, 0.1, 0.2}, 2).value(), 0);
  EXPECT_EQ(length_of({0, 1, 5}, 1, 0.3, 0.3).value(), 0);
}

/// Parts add up, a scaled curve has a scaled length, and one that is run through backwards the same.
TEST(TrueLength, AddsUp) {
  std::mt19937_64 words(1);
  for (const int n : {2, 3, 6, 12}) {
    std::vector<double> points;
    for (int i = 0; i < 2 * (n + 1); ++i) points.push_back(static_cast<double>(static_cast<std::int64_t>(words())));
    const auto whole = length_of(points, 2);
    expect_digits(whole, length_of(points, 2, 0, 0.375).value() + length_of(points, 2, 0.375, 1).value());
    auto other = points;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(n); ++i)
      for (std::size_t axis = 0; axis < 2; ++axis)
        other[2 * i + axis] = points[2 * (static_cast<std::size_t>(n) - i) + axis] * 0x1p-700;
    expect_digits(length_of(other, 2), ldexp(whole.value(), -700));
  }
}

/// Bernstein coefficients of the Chebyshev polynomial of this degree, (-1)^(n-i) C(2n, 2i) / C(n, i), each rounded.
std::vector<double> chebyshev(int n) {
  std::vector<double> coefficients;
  for (int i = 0; i <= n; ++i) {
    LongReal value = (n - i) % 2 == 0 ? 1 : -1;
    for (int k = 0; k < 2 * i; ++k) value = value * (2 * n - k) / (k + 1);
    for (int k = 0; k < i; ++k) value = value * (k + 1) / (n - k);
    coefficients.push_back(value.convert_to<double>());
  }
  return coefficients;
}

/// T_20 goes 20 times from -1 to 1 or back; its coefficients over [0, 1] are whole numbers over 969.
TEST(TrueLength, OfACurveThatTurnsAsOftenAsItCan) {
  auto points = chebyshev(20);
  for (double& x : points) x = std::round(x * 969);
  expect_digits(length_of(points, 1), 20 * 2 * 969);
}

/// Rounding moves T_64, whose coefficients reach 1e19, a little; T_200 is lost in it.
TEST(TrueLength, EndsAtAnyDegree) {
  EXPECT_GT(length_of(chebyshev(64), 1).value(), 100);
  std::vector<double> flat;
  for (const double x : chebyshev(64)) flat.insert(flat.end(), {x, 1e-6 * x});
  EXPECT_GT(length_of(flat, 2).value(), 100);
  EXPECT_GT(length_of(chebyshev(200), 1).value(), 1e20);
}

/// The part of t^64 up to 1e-300 is 1e-19200 long, and 70 digits suffice for it; for (3t - 1)^9 about 1/3 they do not.
TEST(TrueLength, SaysWhatIsNotCertain) {
  std::vector<double> rests(65, 0.0);
  rests.back() = 1;
  expect_digits(length_of(rests, 1, 0, 1e-300), pow(LongReal(1e-300), 64));
  // (3t - 1)^9, each of its coefficients a whole number
  const std::vector<double> inside{-1, 2, -4, 8, -16, 32, -64, 128, -256, 512};
  expect_digits(length_of(inside, 1), 513);
  try {
    static_cast<void>(length_of(inside, 1, 1.0 / 3, std::nextafter(1.0 / 3, 1)));
    FAIL() << "certain";
  } catch (const NotCertain& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("not certain to 30 digits"), std::string::npos);
  }
}

/// A rounding in the last of 70 digits is not an error.
TEST(TrueLength, HasNoErrorOfItsOwn) {
  EXPECT_EQ(length_of({1, 2}, 1).error_of(1), 0);
  EXPECT_EQ(length_of({1, 2, 4, 6}, 2).error_of(5), 0);
  EXPECT_EQ(length_of({0, 0.5, 2}, 1).error_of(2), 0);
  EXPECT_EQ(length_of({0, 1, 0}, 1).error_of(1), 0);
  EXPECT_EQ(length_of({0, 0, 0.5, 0, 2, 0}, 2).error_of(2), 0);
}

TEST(TrueLength, SaysItInDecimalAndMeasuresErrors) {
  const auto parabola = length_of({0, 0, 0.5, 0, 1, 1}, 2);
  EXPECT_EQ(parabola.decimal(30), "1.47894285754459743382790601943");  // as Python's decimal has sqrt(5)/2 + asinh(2)/4
  EXPECT_EQ(length_of({1, 2, 4, 6}, 2).error_of(5.25), 0.25);
  EXPECT_EQ(parabola.error_of(std::numeric_limits<double>::quiet_NaN()), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace bezierbench::reference
