// SPDX-License-Identifier: MIT
#include "reference/float_values.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace bezierbench::reference {
namespace {

struct Case {
  std::vector<float> control_points;
  std::uint64_t max_left_by_doubles;  ///< of about 36,000 values
};

/// Curves that begin or end at 0 or at a power of two, cross 0, go through many binades, are constant, or have tiny or
/// large coordinates.
const std::vector<Case>& cases() {
  static const std::vector<Case> all{{{0.0F, 0.25F, 0.25F, 1.0F}, 1000},
                                     {{0.0F, 0.0F, 1.0F, 1.0F}, 1000},
                                     {{1.0F, 1.0F, 0.55228475F, 0.0F}, 1000},
                                     {{-1.0F, -1.0F, 0.0F, 0.0F}, 1000},
                                     {{-4.0F, -3.9999998F, 0x1p-100F}, 20000},
                                     {{-3.0F, 11.0F / 3, -11.0F / 3, 3.0F}, 5000},
                                     {{0x1p-149F, 0x1p-126F, 0x1.8p-130F}, 20000},
                                     {{0x1p+127F, -0x1p+127F, 0x1.fffffep+127F}, 1000},
                                     {{1.0F, 1.0F, 1.0F}, 200000},
                                     {{0.1F}, 200000},
                                     {{1, -2, 3, -4, 5, -6, 7, -8, 9, -10, 11, -12, 13}, 100000}};
  return all;
}

/// Consecutive floats from many places of [0, 1] on.
std::vector<std::vector<float>> parameters() {
  std::vector<std::vector<float>> all;
  const auto one = std::bit_cast<std::uint32_t>(1.0F);
  for (std::uint32_t from = 0; from < one; from += one / 31) {
    auto& t = all.emplace_back();
    for (std::uint32_t bits = from; bits <= one && t.size() < float_values_at_once; ++bits)
      t.push_back(std::bit_cast<float>(bits));
  }
  for (const float around : {0x1p-8F, 0.25F, 0.5F, 1.0F}) {
    auto& t = all.emplace_back();
    const auto middle = std::bit_cast<std::uint32_t>(around);
    for (std::uint32_t bits = middle - 500; bits <= std::min(middle + 500, one); ++bits)
      t.push_back(std::bit_cast<float>(bits));
  }
  return all;
}

TEST(FloatValues, AreThoseOfTheIntegers) {
  for (const auto& [control_points, max_left] : cases()) {
    FloatValuesOf values_of(control_points);
    const std::vector<double> coefficients(control_points.begin(), control_points.end());
    const CurveView<double> curve{Form::bernstein, 1, static_cast<int>(coefficients.size()) - 1, coefficients};
    ExactCurve exact;
    FloatValues values;
    for (const auto& t : parameters()) {
      values_of.find(t, values);
      for (std::size_t k = 0; k < t.size(); ++k) {
        const Rational value = exact.point(curve, t[k]).coordinate(0);
        const double nearest = round_to(binary32, value);
        ASSERT_EQ(double{values.nearest[k]}, nearest) << coefficients.size() << " points, t = " << t[k];
        const long exponent = value.numerator == 0 ? -126 : std::max(floor_log2(value), -126L);
        ASSERT_EQ(double{values.scale[k]} * double{values.scale_too[k]},
                  std::ldexp(1.0, static_cast<int>(23 - exponent)))
            << coefficients.size() << " points, t = " << t[k];
        const Rational rest = value - exactly(nearest);
        const double in_ulp = std::ldexp(round_to(binary64, rest), static_cast<int>(23 - exponent));
        ASSERT_NEAR(double{values.rest[k]}, in_ulp, 0x1p-19);
      }
    }
    EXPECT_LE(values_of.left_by_doubles(), max_left) << coefficients.size() << " points from " << coefficients.front();
  }
}

}  // namespace
}  // namespace bezierbench::reference
