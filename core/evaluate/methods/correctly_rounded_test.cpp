// SPDX-License-Identifier: MIT
// Every result is the number nearest to the exact value, whichever stage found it, and the stages are where they
// should be: the pair decides nearly everything, the integers what is left.
#include "core/evaluate/methods/correctly_rounded.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/evaluate/methods/correctly_rounded_power.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench {
namespace {

template <class Scalar>
constexpr reference::Format format = sizeof(Scalar) == sizeof(double) ? reference::binary64 : reference::binary32;

enum class Stage { pair, p_tilde, integers };

template <class Scalar>
struct Found {
  Scalar value;
  Stage stage;
};

template <class E, class Scalar>
Found<Scalar> found(const std::vector<Scalar>& coefficients, Scalar t) {
  const int n = static_cast<int>(coefficients.size()) - 1;
  Curve<E::info.form, Scalar, 1> curve(n);
  for (int i = 0; i <= n; ++i) curve(0, i) = coefficients[static_cast<std::size_t>(i)];
  const auto prepared = E::prepare(curve);
  const Scalar value = E::evaluate(prepared, t)[0];
  if (!std::isnan(decided<Scalar>(E::template pairs<1>(prepared, t)[0], prepared.rounding[0])))
    return {value, Stage::pair};
  const bool by_p_tilde = !std::isnan(settled_by_p_tilde(prepared.axis(0), t, E::info.form));
  return {value, by_p_tilde ? Stage::p_tilde : Stage::integers};
}

template <class E, class Scalar>
Scalar nearest(const std::vector<Scalar>& coefficients, Scalar t) {
  static reference::ExactCurve exact;
  const std::vector<double> widened(coefficients.begin(), coefficients.end());
  const CurveView<double> curve{E::info.form, 1, static_cast<int>(coefficients.size()) - 1, widened};
  return static_cast<Scalar>(reference::round_to(format<Scalar>, exact.point(curve, double{t}).coordinate(0)));
}

/// Returns the stage; zeros of either sign are the same number.
template <class E, class Scalar>
Stage expect_nearest(const std::vector<Scalar>& coefficients, Scalar t) {
  const auto ours = found<E>(coefficients, t);
  const Scalar right = nearest<E>(coefficients, t);
  EXPECT_EQ(ours.value, right) << name(E::info.form) << " degree " << coefficients.size() - 1 << " t " << t << " stage "
                               << static_cast<int>(ours.stage);
  return ours.stage;
}

template <class Scalar>
class Inputs {
 public:
  using Limits = std::numeric_limits<Scalar>;
  explicit Inputs(std::uint64_t seed) : words_(seed) {}
  std::uint64_t below(std::uint64_t count) { return words_() % count; }
  Scalar unit() { return static_cast<Scalar>(std::ldexp(static_cast<double>(words_() >> 11U), -53)); }
  Scalar symmetric() { return 2 * unit() - 1; }
  /// Any finite number, all exponents alike.
  Scalar any() {
    const int span = Limits::max_exponent - Limits::min_exponent + Limits::digits;
    return std::ldexp(symmetric(), Limits::max_exponent - static_cast<int>(below(static_cast<std::uint64_t>(span))));
  }
  /// Anything in [0,1]: next to the ends, subnormal, dyadic, uniform.
  Scalar any_unit() {
    const auto bits = static_cast<std::uint64_t>(Limits::digits - Limits::min_exponent);
    switch (below(6)) {
      case 0: return std::ldexp(unit(), -static_cast<int>(below(bits)));
      case 1: return 1 - std::ldexp(unit(), -static_cast<int>(below(Limits::digits + 1)));
      case 2: return static_cast<Scalar>(below(17)) / 16;
      case 3: return Limits::denorm_min() * static_cast<Scalar>(below(100));
      default: return unit();
    }
  }
  template <class Of>
  std::vector<Scalar> coefficients(int degree, const Of& of) {
    std::vector<Scalar> result(static_cast<std::size_t>(degree) + 1);
    for (auto& value : result) value = of(*this);
    return result;
  }

 private:
  std::mt19937_64 words_;
};

template <class T>
struct Case;
template <class E, class ScalarT>
struct Case<std::pair<E, ScalarT>> {
  using Method = E;
  using Scalar = ScalarT;
};

template <class T>
class CorrectlyRoundedIn : public testing::Test {};
using All = testing::Types<std::pair<CorrectlyRounded, double>, std::pair<CorrectlyRoundedPower, double>,
                           std::pair<CorrectlyRounded, float>, std::pair<CorrectlyRoundedPower, float>>;
TYPED_TEST_SUITE(CorrectlyRoundedIn, All);

template <class E, class Scalar, class Of>
void expect_all_nearest(std::uint64_t seed, const Of& of, int max_curves = 200) {
  Inputs<Scalar> inputs(seed);
  for (const int degree : {0, 1, 2, 3, 5, 8, 13, 20, 34, 64}) {
    const int curves = degree > 20 ? max_curves / 8 : max_curves;
    for (int repeat = 0; repeat < curves; ++repeat) {
      const auto coefficients = inputs.coefficients(degree, of);
      for (int k = 0; k < 3; ++k) expect_nearest<E>(coefficients, inputs.any_unit());
    }
  }
}

TYPED_TEST(CorrectlyRoundedIn, RandomCurves) {
  using C = Case<TypeParam>;
  expect_all_nearest<typename C::Method, typename C::Scalar>(1, [](auto& inputs) { return inputs.symmetric(); });
}

TYPED_TEST(CorrectlyRoundedIn, CoefficientsOfEveryMagnitude) {
  using C = Case<TypeParam>;
  expect_all_nearest<typename C::Method, typename C::Scalar>(2, [](auto& inputs) { return inputs.any(); });
}

TYPED_TEST(CorrectlyRoundedIn, SubnormalCurves) {
  using C = Case<TypeParam>;
  using Scalar = typename C::Scalar;
  expect_all_nearest<typename C::Method, Scalar>(3, [](auto& inputs) {
    return std::ldexp(inputs.symmetric(),
                      std::numeric_limits<Scalar>::min_exponent - static_cast<int>(inputs.below(30)));
  });
}

/// Ties, numbers that are representable, and sums that cancel: integers over small powers of two.
TYPED_TEST(CorrectlyRoundedIn, SmallIntegers) {
  using C = Case<TypeParam>;
  using Scalar = typename C::Scalar;
  expect_all_nearest<typename C::Method, Scalar>(4,
                                                 [](auto& inputs) { return static_cast<Scalar>(inputs.below(9)) - 4; });
}

/// Power form overflows to infinity, and comes near to it.
TYPED_TEST(CorrectlyRoundedIn, NumbersNextToTheLargest) {
  using C = Case<TypeParam>;
  using Scalar = typename C::Scalar;
  expect_all_nearest<typename C::Method, Scalar>(5, [](auto& inputs) {
    const Scalar largest = std::numeric_limits<Scalar>::max();
    return inputs.below(3) == 0 ? largest : inputs.symmetric() * largest;
  });
}

/// The pair decides all but a few random points: the bound is what keeps the others fast.
TYPED_TEST(CorrectlyRoundedIn, ThePairDecidesRandomPoints) {
  using C = Case<TypeParam>;
  using Scalar = typename C::Scalar;
  Inputs<Scalar> inputs(6);
  int left = 0;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const auto coefficients = inputs.coefficients(20, [](auto& from) { return from.symmetric(); });
    left += found<typename C::Method>(coefficients, inputs.unit()).stage == Stage::pair ? 0 : 1;
  }
  EXPECT_LE(left, sizeof(Scalar) == sizeof(double) ? 0 : 100);
}

TYPED_TEST(CorrectlyRoundedIn, WhatIsNoInputGivesNaN) {
  using C = Case<TypeParam>;
  using Scalar = typename C::Scalar;
  using Limits = std::numeric_limits<Scalar>;
  const std::vector<Scalar> fine{1, 2, 3};
  for (const Scalar t : {-Limits::denorm_min(), Scalar(2), std::nextafter(Scalar(1), Scalar(2)), Limits::infinity(),
                         -Limits::infinity(), Limits::quiet_NaN()})
    EXPECT_TRUE(std::isnan(found<typename C::Method>(fine, t).value)) << t;
  for (const Scalar bad : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
    EXPECT_TRUE(std::isnan(found<typename C::Method>({1, bad, 3}, Scalar(0.5)).value)) << bad;
}

TEST(CorrectlyRounded, AnExactTieGoesToTheEvenNumber) {
  const double u = 0x1p-53;
  for (const double even : {1.0, 1 + 4 * u}) {
    EXPECT_EQ(found<CorrectlyRounded>({even, even + 2 * u}, 0.5).value, even);          // the midpoint, up or down
    EXPECT_EQ(found<CorrectlyRounded>({even - 2 * u, even + 4 * u}, 0.5).value, even);  // even + u, unless even is 1
    EXPECT_EQ((found<CorrectlyRounded>({even, even + 2 * u}, 0.5).stage), Stage::integers);
  }
  EXPECT_EQ(found<CorrectlyRoundedPower>({1.0, u}, 1.0).value, 1);
  EXPECT_EQ(found<CorrectlyRoundedPower>({1 + 2 * u, u}, 1.0).value, 1 + 4 * u);
}

/// A number beside a tie, by less than any pair can hold.
TEST(CorrectlyRounded, TheLastBitOfAllDecides) {
  const double u = 0x1p-53;
  for (const double tiny : {0x1p-200, 0x1p-1074})
    for (const double sign : {-1.0, 1.0}) {
      EXPECT_EQ(found<CorrectlyRoundedPower>({1.0, u, sign * tiny}, 1.0).value, sign < 0 ? 1 : 1 + 2 * u);
      EXPECT_EQ(found<CorrectlyRounded>({1.0, 1.0 + sign * tiny, 1.0 + 4 * u}, 0.5).value, 1.0);
      expect_nearest<CorrectlyRounded>({1.0, sign * tiny, 1.0 + 2 * u, 1.0}, 0.5);
    }
}

TEST(CorrectlyRounded, CancellationToNothingIsZero) {
  EXPECT_EQ(found<CorrectlyRounded>({1.0, 0.0, -1.0}, 0.5).value, 0);
  EXPECT_FALSE(std::signbit(found<CorrectlyRounded>({-1.0, 0.0, 1.0}, 0.5).value));
  EXPECT_EQ(found<CorrectlyRounded>({0.0, 0.0, 0.0}, 0.3).stage, Stage::pair);  // a curve in a plane has many of these
  EXPECT_EQ(found<CorrectlyRoundedPower>({0.25, -1.0, 1.0}, 0.5).value, 0);
}

TEST(CorrectlyRounded, RoundsSubnormalResultsOnce) {
  const double eta = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(found<CorrectlyRounded>({0.0, eta}, 0.5).value, 0);  // a tie
  EXPECT_EQ(found<CorrectlyRounded>({0.0, eta}, std::nextafter(0.5, 1.0)).value, eta);
  EXPECT_EQ(found<CorrectlyRounded>({eta, 2 * eta}, 0.5).value, 2 * eta);
  EXPECT_TRUE(std::signbit(found<CorrectlyRounded>({0.0, -eta}, 0.25).value));
  // 53 bits are rounded first, and then again, where a result is computed as a normal number and scaled down.
  EXPECT_EQ(found<CorrectlyRoundedPower>({0.0, 0x1p-1022 + eta}, 0.5).value, 0x1p-1023);
  const double t = 0.5 + 0x1p-53;
  expect_nearest<CorrectlyRoundedPower>({0.0, 3 * eta}, t);
  expect_nearest<CorrectlyRoundedPower>({0.0, 5 * eta}, std::nextafter(0.5, 0.0));
}

TEST(CorrectlyRounded, PowerFormOverflowsWithTheRightSign) {
  const double largest = std::numeric_limits<double>::max();
  const double infinity = std::numeric_limits<double>::infinity();
  const double half_ulp = 0x1p+970;
  EXPECT_EQ(found<CorrectlyRoundedPower>({largest, largest}, 1.0).value, infinity);
  EXPECT_EQ(found<CorrectlyRoundedPower>({-largest, -largest}, 0.5).value, -infinity);
  EXPECT_EQ(found<CorrectlyRoundedPower>({largest, half_ulp}, 1.0).value, infinity);  // a tie
  EXPECT_EQ(found<CorrectlyRoundedPower>({largest, std::nextafter(half_ulp, 0.0)}, 1.0).value, largest);
  EXPECT_EQ(found<CorrectlyRoundedPower>({largest, half_ulp, -1.0}, 1.0).value, largest);
  EXPECT_EQ(found<CorrectlyRoundedPower>({largest, largest, -largest}, 1.0).value, largest);
}

TEST(CorrectlyRounded, TheIntegersHaveRoomForTheLargestDegree) {
  Inputs<double> inputs(7);
  const double eta = std::numeric_limits<double>::denorm_min();
  for (const double t : {eta, 0x1.fffffffffffffp-1, 0.3, 0x1.fffffffffffffp-1000}) {
    auto coefficients = inputs.coefficients(rounded_max_degree, [](auto& from) { return from.any(); });
    coefficients[1] = eta;
    coefficients[2] = std::numeric_limits<double>::max();
    const CoordinateView<double> view{coefficients.data(), 1, rounded_max_degree};
    EXPECT_EQ(rounded_bernstein_sum(view, t), nearest<CorrectlyRounded>(coefficients, t)) << t;
    EXPECT_EQ(rounded_power_sum(view, t), nearest<CorrectlyRoundedPower>(coefficients, t)) << t;
  }
}

/// The bound of the pair is proved; here it is seen that it is not far too large, and that nothing passes it.
TYPED_TEST(CorrectlyRoundedIn, ThePairKeepsItsBound) {
  using C = Case<TypeParam>;
  using E = typename C::Method;
  using Scalar = typename C::Scalar;
  Inputs<Scalar> inputs(8);
  reference::ExactCurve exact;
  double largest = 0;
  for (const int degree : {1, 2, 5, 20, 64})
    for (int repeat = 0; repeat < 100; ++repeat) {
      Curve<E::info.form, Scalar, 1> curve(degree);
      for (int i = 0; i <= degree; ++i) curve(0, i) = i % 7 == 3 ? inputs.symmetric() : 1 + inputs.unit() / 2;
      const auto prepared = E::prepare(curve);
      const Scalar t = repeat % 4 == 0 ? inputs.any_unit() : inputs.unit();
      const auto pair = E::template pairs<1>(prepared, t)[0];
      std::vector<double> coefficients(static_cast<std::size_t>(degree) + 1);
      for (int i = 0; i <= degree; ++i) coefficients[static_cast<std::size_t>(i)] = curve(0, i);
      const auto truth = exact.point({E::info.form, 1, degree, coefficients}, double{t}).coordinate(0);
      const auto unit = reference::exactly(double{prepared.rounding[0].unit});
      const auto missed =
          truth - (reference::exactly(double{pair.value}) + reference::exactly(double{pair.error})) * unit;
      const double error = reference::round_to(reference::binary64, reference::abs(missed));
      largest = std::max(largest, error / double{prepared.rounding[0].error} / double{prepared.rounding[0].unit});
    }
  EXPECT_LE(largest, 0.5);  // the other half is for what the first order leaves out
  EXPECT_GE(largest, 0x1p-20);
}

}  // namespace
}  // namespace bezierbench
