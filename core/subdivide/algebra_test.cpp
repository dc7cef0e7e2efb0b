// SPDX-License-Identifier: MIT
// The formulas alone: in exact rational arithmetic every method gives the exact halves.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <vector>

#include "core/subdivide/roster.hpp"

namespace bezierbench {
namespace {

namespace mp = boost::multiprecision;
using Rational = mp::number<mp::cpp_rational_backend, mp::et_off>;
constexpr int degree = 6;

/// sum c_j C(n,j) s^j (1-s)^(n-j), summed term by term.
Rational bernstein(const std::vector<Rational>& c, const Rational& s) {
  Rational sum = 0;
  Rational binomial = 1;
  const int n = static_cast<int>(c.size()) - 1;
  for (int j = 0; j <= n; ++j) {
    Rational term = binomial * c[static_cast<std::size_t>(j)];
    for (int k = 0; k < n; ++k) term *= k < j ? s : Rational(1 - s);
    sum += term;
    binomial = binomial * (n - j) / (j + 1);
  }
  return sum;
}

/// The numerator and the denominator of a curve of dimension 1, as polynomials in Bernstein form.
std::vector<Rational> numerator(const Curve<Form::bernstein, Rational, 1, degree>& curve) {
  std::vector<Rational> c;
  for (int i = 0; i <= degree; ++i) c.push_back(curve(0, i));
  return c;
}
std::vector<Rational> denominator(const Curve<Form::bernstein, Rational, 1, degree>& /*curve*/) {
  return std::vector<Rational>(degree + 1, 1);
}
std::vector<Rational> numerator(const Curve<Form::rational, Rational, 1, degree>& curve) {
  std::vector<Rational> c;
  for (int i = 0; i <= degree; ++i) c.push_back(curve.weights[i] * curve.points(0, i));
  return c;
}
std::vector<Rational> denominator(const Curve<Form::rational, Rational, 1, degree>& curve) {
  std::vector<Rational> c;
  for (int i = 0; i <= degree; ++i) c.push_back(curve.weights[i]);
  return c;
}

void set(Curve<Form::bernstein, Rational, 1, degree>& curve, int number) {
  for (int i = 0; i <= degree; ++i)
    curve(0, i) = Rational((7 * i * i - 11 * i * number + 3) % 17, 1 + (i + number) % 5);
}
void set(Curve<Form::rational, Rational, 1, degree>& curve, int number) {
  set(curve.points, number);
  for (int i = 0; i <= degree; ++i) curve.weights[i] = Rational(1 + (5 * i + number) % 7, 2 + i % 3);
}

/// Expects left(s) = whole(s t) and right(s) = whole(t + s (1-t)) at n + 1 places, which determine polynomials of
/// degree n.
void expect_halves(const std::vector<Rational>& whole, const std::vector<Rational>& left,
                   const std::vector<Rational>& right, const Rational& t, std::string_view id) {
  for (int k = 0; k <= degree; ++k) {
    const Rational s(k, 3);
    EXPECT_EQ(bernstein(left, s), bernstein(whole, s * t)) << id << " t " << t;
    EXPECT_EQ(bernstein(right, s), bernstein(whole, t + s * (1 - t))) << id << " t " << t;
  }
}

template <SplitMethod M>
void expect_exact() {
  // two of these are outside [0,1], chosen such that no weight of a half is 0
  for (int number = 1; number <= 4; ++number)
    for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1, 2), Rational(5, 7), Rational(1),
                              Rational(-10, 97), Rational(108, 97)}) {
      Curve<M::info.form, Rational, 1, degree> curve(degree);
      set(curve, number);
      const auto halves = M::split(curve, t);
      expect_halves(numerator(curve), numerator(halves.left), numerator(halves.right), t, M::info.id);
      expect_halves(denominator(curve), denominator(halves.left), denominator(halves.right), t, M::info.id);
    }
}

template <class... Ms>
void expect_all_exact(TypeList<Ms...> /*methods*/) {
  (expect_exact<Ms>(), ...);
}

TEST(SplitAlgebra, EveryMethodGivesTheHalvesWhenNothingRounds) { expect_all_exact(SplitMethods{}); }

}  // namespace
}  // namespace bezierbench
