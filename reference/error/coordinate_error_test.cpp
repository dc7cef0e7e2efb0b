// SPDX-License-Identifier: MIT
#include "reference/error/coordinate_error.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace bezierbench::reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(CoordinateError, IsMeasuredInEveryUnit) {
  const Rational third{1, 3, 0};  // p~ is 1/3, too: errors over it are relative
  const auto judged = coordinate_error(0.25, third, third);
  EXPECT_EQ(judged.exact, 1.0 / 3);
  EXPECT_EQ(judged.error, 1.0 / 12);
  EXPECT_EQ(judged.error_ulp, 1.0 / 12 * 0x1p+54);  // 1/3 lies in [2^-2, 2^-1)
  EXPECT_EQ(judged.error_u, 0x1p+51);
}

TEST(CoordinateError, OfAValueWithoutScale) {
  const Rational zero;
  EXPECT_EQ(coordinate_error(0, zero, zero).error_u, 0);
  EXPECT_EQ(coordinate_error(1, zero, zero).error_u, infinity);
  EXPECT_EQ(coordinate_error(0x1p-1074, zero, zero).error_ulp, 1);
  for (const double lost : {infinity, std::numeric_limits<double>::quiet_NaN()}) {
    const auto judged = coordinate_error(lost, exactly(2), exactly(2));
    EXPECT_EQ(judged.exact, 2);
    EXPECT_EQ(judged.error, infinity);
    EXPECT_EQ(judged.error_ulp, infinity);
    EXPECT_EQ(judged.error_u, infinity);
  }
}

TEST(CoordinateBound, IsThatOfTheAxis) {
  const ErrorBound bound{.text = "3 p~",
                         .amplification = Amplification::p_tilde_bernstein,
                         .factor = [](int, double) { return 3.0; },
                         .underflow = [](int) { return 0.0; }};
  constexpr std::array coefficients{1.0, 16.0, -3.0, 16.0};  // p~ at t = 1/2 is 2 in x, 16 in y
  const CurveView<double> curve{Form::bernstein, 2, 1, coefficients, {}};
  const double x = coordinate_bound(bound, curve, 0, 0.5, exactly(-1));
  const double y = coordinate_bound(bound, curve, 1, 0.5, exactly(16));
  EXPECT_NEAR(x, 6 * 0x1p-53, 0x1p-70);
  EXPECT_NEAR(y, 48 * 0x1p-53, 0x1p-67);
  EXPECT_NEAR(*bound_units(y, exactly(16)), 3, 0x1p-20);
}

TEST(CoordinateBound, HasNoUnitsWhereNothingIsProved) {
  EXPECT_FALSE(bound_units(infinity, exactly(1)));
  EXPECT_FALSE(bound_units(1, Rational{}));
}

}  // namespace
}  // namespace bezierbench::reference
