// SPDX-License-Identifier: MIT
#include "reference/true_length.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
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

TEST(TrueLength, SaysItInDecimalAndMeasuresErrors) {
  const auto parabola = length_of({0, 0, 0.5, 0, 1, 1}, 2);
  EXPECT_EQ(parabola.decimal(30), "1.47894285754459743382790601943");  // as Python's decimal has sqrt(5)/2 + asinh(2)/4
  EXPECT_EQ(length_of({1, 2, 4, 6}, 2).error_of(5.25), 0.25);
  EXPECT_EQ(parabola.error_of(std::numeric_limits<double>::quiet_NaN()), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace bezierbench::reference
