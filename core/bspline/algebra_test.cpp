// SPDX-License-Identifier: MIT
// The formulas alone, in exact rational arithmetic. The control points of a polynomial over given knots are its blossom
// at n neighbouring knots, whatever the knots are (Marsden's identity), so every method has to return the polynomial.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <vector>

#include "core/bspline/bspline.hpp"
#include "core/bspline/roster.hpp"

namespace bezierbench {
namespace {

namespace mp = boost::multiprecision;
using Rational = mp::number<mp::cpp_rational_backend, mp::et_off>;
using Numbers = std::vector<Rational>;

/// The blossom of sum q_j t^j: t^j becomes the mean of the products of j of the arguments.
Rational blossom(const Numbers& q, const Numbers& arguments) {
  Numbers symmetric(q.size(), Rational(0));  // the elementary symmetric functions
  symmetric[0] = 1;
  for (const auto& x : arguments)
    for (std::size_t j = q.size() - 1; j > 0; --j) symmetric[j] += x * symmetric[j - 1];
  Rational sum = 0;
  Rational products = 1;  // C(n,j)
  for (std::size_t j = 0; j < q.size(); ++j) {
    sum += q[j] * symmetric[j] / products;
    products = products * static_cast<int>(q.size() - 1 - j) / static_cast<int>(j + 1);
  }
  return sum;
}

Rational value(const Numbers& q, const Rational& t) { return blossom(q, Numbers(q.size() - 1, t)); }

Numbers polynomial(int n) {
  Numbers q;
  for (int j = 0; j <= n; ++j) q.push_back(Rational((7 * j * j - 11 * j + 3) % 17, 1 + j % 5));
  return q;
}

BsplineSpan<Rational, 1> span_of(const Numbers& q, const Numbers& knots) {
  const int n = static_cast<int>(q.size()) - 1;
  BsplineSpan<Rational, 1> span(knots);
  for (int i = 0; i <= n; ++i)
    span.control_points(0, i) = blossom(q, Numbers(knots.begin() + i, knots.begin() + i + n));
  return span;
}

template <class M>
void expect_polynomial(const Numbers& knots) {
  const int n = static_cast<int>(knots.size()) / 2;
  const auto q = polynomial(n);
  const auto span = span_of(q, knots);
  const Rational& a = span.begin();
  const Rational& c = span.end();
  for (const Rational& t : {a, Rational((2 * a + c) / 3), Rational((a + 6 * c) / 7), c}) {
    if constexpr (BsplineConversion<M>)
      EXPECT_EQ(point_of_span(M::convert(span), a, c, t)[0], value(q, t)) << M::info.id << " t " << t;
    else
      EXPECT_EQ(M::evaluate(span, t)[0], value(q, t)) << M::info.id << " t " << t;
  }
  if constexpr (BsplineConversion<M>) {
    const auto bernstein = M::convert(span);
    for (int k = 0; k <= n; ++k) {
      Numbers ends(static_cast<std::size_t>(n), c);
      std::fill_n(ends.begin(), n - k, a);
      EXPECT_EQ(bernstein(0, k), blossom(q, ends)) << M::info.id << " control point " << k;
    }
  }
}

template <class... Ms>
void expect_all(TypeList<Ms...> /*methods*/, const Numbers& knots) {
  (expect_polynomial<Ms>(knots), ...);
}

Rational third(int k) { return {k, 3}; }

TEST(BsplineAlgebra, EveryMethodReturnsThePolynomialOverAnyKnots) {
  expect_all(BsplineMethods{}, {2, 5});                                                              // a line
  expect_all(BsplineMethods{}, {0, 1, 2, 3});                                                        // uniform
  expect_all(BsplineMethods{}, {0, 0, 0, 1, 2, 5});                                                  // clamped
  expect_all(BsplineMethods{}, {3, 3, 3, 4, 4, 4});                                                  // Bernstein form
  expect_all(BsplineMethods{}, {-7, third(-5), third(-5), 1, third(4), 6, 6, 80});                   // a double knot
  expect_all(BsplineMethods{}, {-9, -4, -4, -4, third(1), third(2), third(2), third(2), 5, 7});      // triple knots
  expect_all(BsplineMethods{}, {-1, -1, -1, -1, -1, 0, Rational(1, 1 << 20), 1, 1, 1, 1, 1000000});  // uneven
}

}  // namespace
}  // namespace bezierbench
