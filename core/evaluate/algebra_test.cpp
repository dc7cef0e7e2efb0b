// SPDX-License-Identifier: MIT
// The formulas themselves: run over exact rationals, where nothing rounds, every method gives the point exactly.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>

#include "core/convert/roster.hpp"
#include "core/evaluate/roster.hpp"
#include "core/evaluate/via.hpp"

namespace bezierbench {
namespace {

namespace mp = boost::multiprecision;
using Rational = mp::number<mp::cpp_rational_backend, mp::et_off>;
constexpr int degree = 6;

template <class M>
inline constexpr bool rounds_correctly = false;
template <>
inline constexpr bool rounds_correctly<CorrectlyRounded> = true;
template <>
inline constexpr bool rounds_correctly<CorrectlyRoundedPower> = true;
template <class C, class E>
inline constexpr bool rounds_correctly<Via<C, E>> = rounds_correctly<E>;

/// Methods that cannot run on rationals: libm's pow, and those that are defined by rounding to double.
template <class M>
inline constexpr bool algebraic = M::info.bit_stable && !rounds_correctly<M>;
template <class E>
inline constexpr bool algebraic<Via<ExactToPower, E>> = false;
template <class E>
inline constexpr bool algebraic<Via<ExactToPowerDoubleDouble, E>> = false;
template <class E>
inline constexpr bool algebraic<Via<ExactToPowerCentered, E>> = false;
template <class E>
inline constexpr bool algebraic<Via<ExactToBernstein, E>> = false;

Rational power(const Rational& base, int exponent) {
  Rational result = 1;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

/// The definition of a polynomial curve, term by term.
Rational definition(Form form, const std::vector<Rational>& c, const Rational& t) {
  Rational sum = 0;
  Rational binomial = 1;
  for (int i = 0; i <= degree; ++i) {
    const auto& coefficient = c[static_cast<std::size_t>(i)];
    sum += form == Form::bernstein ? Rational(binomial * power(t, i) * power(1 - t, degree - i) * coefficient)
                                   : Rational(coefficient * power(t, i));
    binomial = binomial * (degree - i) / (i + 1);
  }
  return sum;
}

/// A sample curve in form F, on one axis, and its point by definition.
template <Form F>
struct Sample {
  explicit Sample(int number) {
    std::vector<Rational> c;
    for (int i = 0; i <= degree; ++i) {
      c.emplace_back((7 * i * i - 11 * i * number + 3) % 17, 1 + (i + number) % 5);
      curve(0, i) = c.back();
    }
    point = definition(F, c, t_of(number));
  }
  /// On both sides of 0; no denominator of a rational scheme vanishes.
  static Rational t_of(int number) { return {2 * number - 5, 7}; }

  Curve<F, Rational, 1, degree> curve{degree};
  Rational point;
};

template <>
struct Sample<Form::rational> {
  explicit Sample(int number) {
    const Sample<Form::bernstein> points(number);
    std::vector<Rational> weighted;
    std::vector<Rational> weights;
    for (int i = 0; i <= degree; ++i) {
      weights.emplace_back(1 + (5 * i + number) % 7, 2 + i % 3);
      weighted.emplace_back(weights.back() * points.curve(0, i));
      curve.weights[i] = weights.back();
    }
    curve.points = points.curve;
    const Rational t = t_of(number);
    point = definition(Form::bernstein, weighted, t) / definition(Form::bernstein, weights, t);
  }
  static Rational t_of(int number) { return Sample<Form::bernstein>::t_of(number); }

  Curve<Form::rational, Rational, 1, degree> curve{degree};
  Rational point;
};

template <class M>
void expect_exact() {
  if constexpr (algebraic<M>) {
    for (int number = 1; number <= 5; ++number) {
      const Sample<M::info.form> sample(number);
      if (M::info.unit_interval_only && sample.t_of(number) < 0) continue;
      EXPECT_EQ(M::evaluate(M::prepare(sample.curve), sample.t_of(number))[0], sample.point)
          << M::info.id << " " << name(M::info.form);
    }
  }
}

template <class... Ms>
void expect_all_exact(TypeList<Ms...> /*methods*/) {
  (expect_exact<Ms>(), ...);
}

TEST(Algebra, EveryMethodIsTheDefinitionWhenNothingRounds) {
  expect_all_exact(typename PathsOf<Conversions, Evaluators>::Type{});
}

/// Its only path starts with a conversion that rounds to double, so it is run on high + low = q directly.
TEST(Algebra, HornerOnDoubleDoubleCoefficientsIsTheDefinition) {
  std::vector<Rational> q;
  Curve<Form::power_double_double, Rational, 1, degree> curve(degree);
  for (int j = 0; j <= degree; ++j) {
    q.emplace_back(5 * j * j - 13, 3 + j);
    curve.low(0, j) = Rational(j - 2, 7);
    curve.high(0, j) = q.back() - curve.low(0, j);
  }
  for (int sample = -3; sample <= 3; ++sample) {
    const Rational t(sample, 5);
    EXPECT_EQ(HornerDoubleDouble::evaluate(HornerDoubleDouble::prepare(curve), t)[0], definition(Form::power, q, t));
  }
}

}  // namespace
}  // namespace bezierbench
