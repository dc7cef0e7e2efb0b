// SPDX-License-Identifier: MIT
// Nodes where they should be, weights that belong to them, and the bound that barycentric.hpp derives.
#include "core/evaluate/schemes/barycentric.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <random>

#include "core/evaluate/methods/barycentric_chebyshev.hpp"
#include "core/evaluate/methods/barycentric_uniform.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench {
namespace {

namespace mp = boost::multiprecision;
using Wide = mp::cpp_bin_float_50;
using Rational = mp::number<mp::cpp_rational_backend, mp::et_off>;
constexpr double u = 0x1p-53;
const std::vector<int> degrees{0, 1, 2, 3, 4, 5, 8, 13, 20, 33, 50, 100, 333, 1000, 1023};

template <class Scalar>
struct Unit;  ///< of roundoff
template <>
struct Unit<double> {
  static constexpr double value = 0x1p-53;
};
template <>
struct Unit<float> {
  static constexpr double value = 0x1p-24;
};

/// The prepared curve whose control points alternate between 1 and -1/2.
template <class E, class Scalar>
PreparedOf<E, Scalar, 1> zigzag(int degree) {
  Curve<Form::bernstein, Scalar, 1> curve(degree);
  for (int i = 0; i <= degree; ++i) curve(0, i) = i % 2 == 0 ? Scalar(1) : Scalar(-1) / Scalar(2);
  return E::prepare(curve);
}

Wide uniform_node(int j, int n) { return Wide(j) / n; }
Wide exact_chebyshev_node(int j, int n) {
  return (1 - cos(boost::math::constants::pi<Wide>() * j / n)) / 2;  // the definition
}

/// The largest distance of a node from its definition, in units of roundoff; also checks order and symmetry.
template <class E, class Scalar, class Definition>
double node_error(int n, Definition definition) {
  const auto nodes = zigzag<E, Scalar>(n).nodes;
  EXPECT_EQ(nodes[0], 0);
  EXPECT_EQ(nodes[n], 1);
  double worst = 0;
  for (int j = 0; j <= n; ++j) {
    EXPECT_EQ(nodes[j] + nodes[n - j], 1) << "j " << j << " n " << n;
    EXPECT_EQ(static_cast<double>(nodes[j]) + static_cast<double>(nodes[n - j]), 1);
    if (j > 0) {
      EXPECT_GT(nodes[j], nodes[j - 1]);
    }
    const Wide error = abs(Wide(nodes[j]) - definition(j, n));
    worst = std::max(worst, static_cast<double>(error) / Unit<Scalar>::value);
  }
  return worst;
}

TEST(Barycentric, NodesAreWhereTheyShouldBe) {
  for (const int n : degrees) {
    if (n == 0) continue;  // a single node, anywhere
    EXPECT_LE((node_error<BarycentricChebyshev, double>(n, exact_chebyshev_node)), 4.6);
    // j/n rounds below 1/2, its sum with 1/2 below 1
    EXPECT_LE((node_error<BarycentricUniform, double>(n, uniform_node)), 0.75);
    // formed in double and rounded once
    EXPECT_LE((node_error<BarycentricChebyshev, float>(n, exact_chebyshev_node)), 0.5 + 4.6 * 0x1p-29);
    EXPECT_LE((node_error<BarycentricUniform, float>(n, uniform_node)), 0.5 + 0.75 * 0x1p-29);
  }
}

/// Each weight is that of the rounded nodes except for n roundings, whatever the closed form says.
template <class E, class Scalar>
void expect_weights_of_the_nodes(int n) {
  const auto prepared = zigzag<E, Scalar>(n);
  std::vector<Rational> products(static_cast<std::size_t>(n) + 1, 1);
  Rational smallest;
  for (int j = 0; j <= n; ++j) {
    auto& product = products[static_cast<std::size_t>(j)];
    for (int k = 0; k <= n; ++k)
      if (k != j) product *= Rational(prepared.nodes[j]) - Rational(prepared.nodes[k]);
    smallest = j == 0 ? Rational(abs(product)) : std::min(smallest, Rational(abs(product)));
  }
  const double one = gamma_over_u(n, u) * u;  // n-1 products and the quotient, and the same for `smallest`
  const double rounding_to_scalar = Unit<Scalar>::value > u ? Unit<Scalar>::value : 0;
  const double allowed = 2 * one / (1 - one) + rounding_to_scalar;
  for (int j = 0; j <= n; ++j) {
    const Rational exact = smallest / products[static_cast<std::size_t>(j)];
    EXPECT_LE(abs(Rational(prepared.weights[j]) - exact), Rational(allowed) * abs(exact)) << E::info.id << " n " << n;
  }
}

TEST(Barycentric, WeightsBelongToTheRoundedNodes) {
  for (const int n : {1, 2, 5, 20, 65}) {
    expect_weights_of_the_nodes<BarycentricChebyshev, double>(n);
    expect_weights_of_the_nodes<BarycentricChebyshev, float>(n);
    expect_weights_of_the_nodes<BarycentricUniform, double>(n);
    expect_weights_of_the_nodes<BarycentricUniform, float>(n);
  }
}

template <class E, class Scalar>
void expect_finite_at_the_largest_degree(int n) {
  const auto prepared = zigzag<E, Scalar>(n);
  for (int j = 0; j <= n; ++j) {
    EXPECT_TRUE(std::isnormal(prepared.weights[j])) << E::info.id << " j " << j;
    EXPECT_EQ(E::evaluate(prepared, prepared.nodes[j])[0], prepared.values(0, j));
  }
  EXPECT_TRUE(std::isfinite(E::evaluate(prepared, Scalar(1) / Scalar(3))[0]));
  EXPECT_EQ(prepared.values(0, 0), 1);
  EXPECT_EQ(prepared.values(0, n), n % 2 == 0 ? Scalar(1) : Scalar(-1) / Scalar(2));
}

TEST(Barycentric, HoldsUpToTheDegreesThatItStates) {
  expect_finite_at_the_largest_degree<BarycentricChebyshev, double>(BarycentricChebyshev::info.max_degree);
  expect_finite_at_the_largest_degree<BarycentricChebyshev, float>(BarycentricChebyshev::info.max_degree_float);
  expect_finite_at_the_largest_degree<BarycentricUniform, double>(BarycentricUniform::info.max_degree);
  expect_finite_at_the_largest_degree<BarycentricUniform, float>(BarycentricUniform::info.max_degree_float);
}

/// |computed - p| over what barycentric.hpp allows for max|b| <= 1 and this Lebesgue constant, at the worst of some t.
template <class E, class Scalar>
double bound_used(int n, double lebesgue) {
  std::mt19937_64 words(static_cast<std::uint64_t>(n));
  const double unit = Unit<Scalar>::value;
  const double numerator = gamma_over_u(2 * n + 4, unit) * unit * lebesgue;
  const double denominator = gamma_over_u(2 * n + 2, unit) * unit * lebesgue;
  EXPECT_LT(denominator, 1) << "the bound is infinite at n = " << n;
  const double allowed = (numerator + denominator) / (1 - denominator) * (1 + unit) + unit;
  reference::ExactCurve exact;
  double worst = 0;
  for (int repeat = 0; repeat < (n > 100 ? 1 : 10); ++repeat) {
    Curve<Form::bernstein, Scalar, 1> curve(n);
    std::vector<double> coefficients;
    for (int i = 0; i <= n; ++i) {
      curve(0, i) = static_cast<Scalar>(static_cast<double>(static_cast<std::int64_t>(words())) * 0x1p-63);
      coefficients.push_back(static_cast<double>(curve(0, i)));
    }
    const auto prepared = E::prepare(curve);
    std::vector<Scalar> parameters{Scalar(0x1p-30), Scalar(0.25), Scalar(1) - Scalar(unit)};
    const int middle = n / 2;  // next to a node
    if (n > 1) parameters.push_back(std::nextafter(prepared.nodes[middle], Scalar(1)));
    for (int k = 0; k < 6; ++k)
      parameters.push_back(static_cast<Scalar>(static_cast<double>(words() >> 11U) * 0x1p-53));
    for (const Scalar t : parameters) {
      const std::vector<double> computed{static_cast<double>(E::evaluate(prepared, t)[0])};
      const CurveView<double> view{Form::bernstein, 1, n, coefficients};
      const double error = reference::Distance(exact.point(view, static_cast<double>(t))).to(computed);
      worst = std::max(worst, error / allowed);
    }
  }
  return worst;
}

TEST(Barycentric, ChebyshevKeepsTheBoundOfItsLebesgueConstant) {
  for (const int n : degrees) {
    // [Ehlich and Zeller 1966], for unrounded nodes; 1 % for their rounding: it moves the second node by 1 % in float
    const double lebesgue = 1.01 * (1 + 2 / 3.141592653589793 * std::log(n + 1));
    EXPECT_LE((bound_used<BarycentricChebyshev, double>(n, lebesgue)), 1) << "n " << n;
    EXPECT_LE((bound_used<BarycentricChebyshev, float>(n, lebesgue)), 1) << "n " << n;
  }
}

TEST(Barycentric, UniformKeepsTheBoundOfItsLebesgueConstant) {
  for (const int n : {0, 1, 2, 3, 5, 8, 13, 20, 33, 45})  // beyond, (2n+2) u 2^n passes 1
    EXPECT_LE((bound_used<BarycentricUniform, double>(n, std::ldexp(1, n))), 1) << "n " << n;
  for (const int n : {0, 1, 2, 3, 5, 8, 13, 18})
    EXPECT_LE((bound_used<BarycentricUniform, float>(n, std::ldexp(1, n))), 1);
}

}  // namespace
}  // namespace bezierbench
