// SPDX-License-Identifier: MIT
// Every method for easing: properties over the roster, answers known from t = 1/2, and what published methods do wrong.
#include "core/easing/roster.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/easing/kernel.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "reference/companion/easing.hpp"

namespace bezierbench {
namespace {

using Curve64 = EasingCurve<double>;

template <class M, class Scalar>
Eased<Scalar> eased(const EasingCurve<Scalar>& curve, Scalar x) {
  return ease<M>(M::prepare(curve), EndSlopes<Scalar>(curve), x);
}

double nearest(const Curve64& c, double x) {
  return reference::ExactEased(c.x1, c.y1, c.x2, c.y2, x).nearest(reference::binary64);
}

/// Random curves, and by `kind` such with vertical tangents, triple roots, tiny or huge numbers.
Curve64 curve_of(Inputs& inputs, int kind) {
  const auto corner = [&] { return std::floor(inputs.unit() * 3) - 1; };
  Curve64 c{inputs.unit(), 4 * inputs.symmetric(), inputs.unit(), 4 * inputs.symmetric()};
  switch (kind) {
    case 1: return {1, 0, 0, 1};
    case 2: return {0, 1, 0, 1};
    case 3: return {std::abs(corner()), corner(), std::abs(corner()), corner()};
    case 4: return {c.x1, c.x1, c.x2, c.x2};
    case 5: return {c.x1, c.y1 * 0x1p-1040, c.x2, c.y2 * 0x1p-1040};
    case 6: return {c.x1, c.y1 * 0x1p1000, c.x2, c.y2 * -0x1p1000};
    case 7: return {c.x1 * 0x1p-600, c.y1, 1 - c.x2 * 0x1p-40, c.y2};
    default: return c;
  }
}
constexpr int kinds = 8;

double x_of(Inputs& inputs, int kind) {
  switch (kind) {
    case 1: return std::ldexp(inputs.unit(), -static_cast<int>(inputs.unit() * 1070));
    case 2: return std::floor(inputs.unit() * 17) / 16;
    case 3: return 0.5 + std::floor(inputs.unit() * 9 - 4) * 0x1p-53;
    default: return inputs.unit();
  }
}

TEST(EasingCorrectlyRounded, IsTheNearestNumber) {
  Inputs inputs(1);
  for (int trial = 0; trial < 4 * kinds * 25; ++trial) {
    const auto c = curve_of(inputs, trial % kinds);
    const double x = x_of(inputs, trial / kinds % 4);
    EXPECT_EQ(eased<EasingCorrectlyRounded>(c, x).y, nearest(c, x)) << trial << " " << std::hexfloat << x;
    const EasingCurve<float> single{static_cast<float>(c.x1), static_cast<float>(std::fmod(c.y1, 1e30)),
                                    static_cast<float>(c.x2), static_cast<float>(std::fmod(c.y2, 1e30))};
    const auto at = static_cast<float>(x);
    EXPECT_EQ(eased<EasingCorrectlyRounded>(single, at).y,
              reference::ExactEased(single.x1, single.y1, single.x2, single.y2, at).nearest(reference::binary32))
        << trial;
  }
}

/// x1 = x2 = 0 gives x = t^3, so t = 1/2 at 1/8, where y = (3 y1 + 3 y2 + 1) / 8.
TEST(EasingCorrectlyRounded, RoundsTiesToEven) {
  const double u = 0x1p-53;
  EXPECT_EQ(exact_easing_sign({0, 1, 0, 4 * u}, 0.125, 0.5 + u, 0.5 + 2 * u), 0);  // y = 1/2 + 3 u / 2
  EXPECT_EQ(eased<EasingCorrectlyRounded>(Curve64{0, 1, 0, 4 * u}, 0.125).y, 0.5 + 2 * u);
  EXPECT_EQ(exact_easing_sign({0, 1, 0, 12 * u}, 0.125, 0.5 + 4 * u, 0.5 + 5 * u), 0);  // y = 1/2 + 9 u / 2
  EXPECT_EQ(eased<EasingCorrectlyRounded>(Curve64{0, 1, 0, 12 * u}, 0.125).y, 0.5 + 4 * u);
}

/// In double, whose errors are large enough to be seen.
TEST(EasingEncloser, EnclosesTheTruth) {
  Inputs inputs(5);
  int found_count = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const auto c = curve_of(inputs, trial % 5);
    const double x = 0.001 + 0.998 * inputs.unit();
    const auto found = EasingEncloser<DoubleArithmetic>(c).at(x, EasingHalley::solve(c, x).t);
    if (!found) continue;
    ++found_count;
    EXPECT_LE(reference::ExactEased(c.x1, c.y1, c.x2, c.y2, x).error(found->high), found->error) << trial;
  }
  EXPECT_GT(found_count, 300);
}

TEST(EasingSign, OfCurvesThroughKnownPoints) {
  // (0, 1, 0, 1): t = 1/2 at x = 1/8, y = 7/8. (1, 0, 0, 1): x(t) - 1/2 has a triple root at 1/2, y = 1/2.
  EXPECT_EQ(exact_easing_sign({0, 1, 0, 1}, 0.125, 0.875, 0.875), 0);
  EXPECT_EQ(exact_easing_sign({0, 1, 0, 1}, 0.125, 0.5, 0.875), 1);
  EXPECT_EQ(exact_easing_sign({0, 1, 0, 1}, 0.125, 0.875, 1), -1);
  EXPECT_EQ(exact_easing_sign({1, 0, 0, 1}, 0.5, 0.5, 0.5), 0);
  EXPECT_EQ(exact_easing_sign({1, 0, 0, 1}, 0.5, 0.5, std::nextafter(0.5, 1)), -1);
  EXPECT_EQ(exact_easing_sign({0, 0x1p-1074, 0, 0}, 0.125, 0, 0), 1);
}

/// y(1/2) of symmetric curves, and lines; to the digits that all methods have.
TEST(Easing, KnownAnswers) {
  struct Known {
    Curve64 curve;
    double x, y;
  };
  for (const auto& [curve, x, y] :
       {Known{{0.42, 0, 0.58, 1}, 0.5, 0.5}, Known{{0, 1, 0, 1}, 0.125, 0.875}, Known{{0, -2, 0, 3}, 0.125, 0.5},
        Known{{0.25, 0.25, 0.5, 0.5}, 0.3, 0.3}, Known{{1, 0, 1, 0}, 0.875, 0.125}, Known{{1, 1, 0, 0}, 0.25, 0.25}})
    for (const auto& kernel : easing_kernels()) {
      Eased<double> in_double;
      kernel.ease(curve, std::span(&x, 1), &in_double);
      EXPECT_NEAR(in_double.y, y, 1e-5) << kernel.info->id;
      Eased<float> in_float;
      const auto at = static_cast<float>(x);
      kernel.ease_float({static_cast<float>(curve.x1), static_cast<float>(curve.y1), static_cast<float>(curve.x2),
                         static_cast<float>(curve.y2)},
                        std::span(&at, 1), &in_float);
      EXPECT_NEAR(double{in_float.y}, y, 1e-4) << kernel.info->id;
    }
}

TEST(Easing, EveryMethodIsNearTheTruth) {
  Inputs inputs(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Curve64 c{0.1 + 0.8 * inputs.unit(), inputs.unit(), 0.1 + 0.8 * inputs.unit(), inputs.unit()};
    const double x = 0.01 + 0.98 * inputs.unit();
    for (const auto& kernel : easing_kernels()) {
      Eased<double> answer;
      kernel.ease(c, std::span(&x, 1), &answer);
      EXPECT_NEAR(answer.y, nearest(c, x), 1e-3) << kernel.info->id;
      EXPECT_TRUE(answer.converged) << kernel.info->id;
    }
  }
}

TEST(Easing, BeyondTheEndsGoesOnAsALine) {
  const auto at = [](const Curve64& c, double x) { return eased<EasingHalley>(c, x).y; };
  EXPECT_EQ(at({0.5, 1, 0.5, 0}, -1), -2);   // through (x1, y1)
  EXPECT_EQ(at({0.5, 1, 0.5, 0}, 2), 3);     // through (x2, y2)
  EXPECT_EQ(at({0, 0, 0.25, 0.5}, -1), -2);  // (x1, y1) is the end: through (x2, y2)
  EXPECT_EQ(at({0, 0, 0, 0}, -3), -3);       // all coincide: through the other end
  EXPECT_EQ(at({0, 1, 0.5, 0.5}, -1), 0);    // vertical
  EXPECT_EQ(at({0, 0, 0, 1}, -1), 0);        // vertical, of the next point
  EXPECT_EQ(at({0.5, 0.25, 1, 1}, 2), 2.5);
  EXPECT_EQ(at({1, 1, 1, 1}, 2), 2);
  EXPECT_EQ(at({0.5, 0.5, 1, 0.5}, 2), 1);
  EXPECT_EQ(at({1, 0.5, 1, 1}, 2), 1);
}

/// x(t) is about 3 x2 t^2 and t^3 there; from t = x it took more than 30 steps.
TEST(EasingHalley, BeginsNearTheRoot) {
  for (const double x : {0x1p-100, 0x1.8p-200, 0x1.1p-301}) {
    EXPECT_LE(eased<EasingHalley>(Curve64{0, 0, 0.58, 1}, x).steps, 8) << x;
    EXPECT_LE(eased<EasingHalley>(Curve64{0, 1, 0, 1}, x).steps, 8) << x;
  }
}

/// Neighbours of x on curves that do not fall, where the tangent is vertical, too.
TEST(EasingCorrectlyRounded, DoesNotGoBack) {
  Inputs inputs(3);
  for (int trial = 0; trial < 60; ++trial) {
    const Curve64 c =
        trial % 3 == 0 ? Curve64{1, 0, 0, 1} : Curve64{inputs.unit(), inputs.unit(), inputs.unit(), inputs.unit()};
    double x = trial % 2 == 0 ? 0.5 - 20 * 0x1p-53 : inputs.unit() * 0.9;
    double before = -1;
    for (int k = 0; k < 40; ++k, x = std::nextafter(x, 1)) {
      const double y = eased<EasingCorrectlyRounded>(c, x).y;
      EXPECT_GE(y, before) << trial << " " << k;
      before = y;
    }
  }
}

/// The count is that of the npm package bezier-easing 2.1.0, asked live by scripts/check audit: results/audit.
TEST(EasingTableNewton, GoesBackAsOftenAsThePackage) {
  const Curve64 c{1, 0, 0, 1};
  const auto prepared = EasingTableNewton::prepare(c);
  int back = 0;
  double most = 0;
  double before = 0;
  for (int k = 1; k <= 1 << 20; ++k) {
    const double y = EasingTableNewton::solve(prepared, k * 0x1p-20).y;
    back += y < before ? 1 : 0;
    if (before - y > most) {
      most = before - y;
      EXPECT_LE(most, 0.000379);
    }
    before = y;
  }
  EXPECT_EQ(back, 1190);
  EXPECT_NEAR(most, 0.6644821823 - 0.6641040743, 1e-10);
}

/// x(t) in float has a larger error than the tolerance: bisection would not end.
TEST(EasingNewtonBisection, DoesNotEndInFloat) {
  Inputs inputs(4);
  int endless = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const EasingCurve<float> c{static_cast<float>(inputs.unit()), 0, static_cast<float>(inputs.unit()), 1};
    endless += eased<EasingNewtonBisection>(c, static_cast<float>(inputs.unit())).converged ? 0 : 1;
  }
  EXPECT_GT(endless, 0);
}

}  // namespace
}  // namespace bezierbench
