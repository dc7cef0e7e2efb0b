// SPDX-License-Identifier: MIT
// The generators of roots have exactly the coefficients of the intended polynomial: computed with rationals.
#include "experiments/sample/roots.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "experiments/sample/draw.hpp"

namespace bezierbench::sample {
namespace {

using Exact = boost::multiprecision::cpp_rational;

constexpr std::array curves{Form::bernstein, Form::power};

Exact power(const Exact& base, int exponent) {
  Exact value = 1;
  for (int k = 0; k < exponent; ++k) value *= base;
  return value;
}

Exact binomial(int n, int i) {
  Exact value = 1;
  for (int k = 0; k < i; ++k) value = value * (n - k) / (k + 1);
  return value;
}

/// The value of the curve at t, from the definition of the basis functions.
Exact value_at(const Exact& t, Form curve, const std::vector<double>& coefficients) {
  const int n = static_cast<int>(coefficients.size()) - 1;
  Exact value = 0;
  for (int i = 0; i <= n; ++i) {
    const Exact basis = curve == Form::power ? power(t, i) : binomial(n, i) * power(t, i) * power(1 - t, n - i);
    value += Exact(coefficients[static_cast<std::size_t>(i)]) * basis;
  }
  return value;
}

std::vector<double> drawn(const GeneratorInfo& info, Form curve, int degree, double range, std::uint64_t trial) {
  Trial out;
  draw(1, 2, {curve, 1, degree, range, {}, std::string(info.id)}, trial, out);
  return out.coefficients;
}

int largest_degree(const GeneratorInfo& info, Form curve) {
  return curve == Form::power ? info.limits.polynomial_degree : info.limits.bezier_degree;
}

// n + 1 values determine a polynomial of degree n.
TEST(MultipleRoot, IsThatPolynomialAtEveryDegree) {
  for (const Form curve : curves) {
    for (int n = 0; n <= largest_degree(MultipleRoot::info, curve); ++n) {
      for (const double range : {1.0, 0x1p-900, 0x1p900}) {
        const auto coefficients = drawn(MultipleRoot::info, curve, n, range, 0);
        for (int k = 0; k <= n; ++k) {
          ASSERT_EQ(value_at(Exact(k), curve, coefficients), Exact(range) * power(Exact(k) - Exact(3, 4), n))
              << n << " " << range;
        }
      }
    }
  }
}

/// The factor that clears the denominators C(n,i): lcm C(n,i) = lcm(1, ..., n+1) / (n+1).
std::int64_t common_multiple(int n) {
  std::int64_t multiple = 1;
  for (std::int64_t k = 1; k <= n + 1; ++k) multiple = std::lcm(multiple, k);
  return multiple / (n + 1);
}

/// The common multiple over the next power of two, so that R remains the scale.
Exact lambda(int n) {
  Exact value = common_multiple(n);
  while (value > 1) value /= 2;
  return value;
}

// n roots and the value at 2 determine a polynomial of degree n.
TEST(ClusteredRoots, HasItsRootsOnTheLatticeAtEveryDegree) {
  for (const Form curve : curves) {
    for (int n = 0; n <= ClusteredRoots::largest_degree; ++n) {
      const Exact step = 1 / power(2, ClusteredRoots::lattice_bits(n));
      for (std::uint64_t trial = 0; trial < 20; ++trial) {
        const double range = std::ldexp(1, static_cast<int>(trial) * 90 - 900);
        const auto coefficients = drawn(ClusteredRoots::info, curve, n, range, trial);
        Exact at_two = Exact(range) * lambda(n);
        int roots = 0;
        for (int k = -n; k <= n; ++k) {
          const Exact root = Exact(1, 2) + k * step;
          if (value_at(root, curve, coefficients) != 0) continue;
          at_two *= 2 - root;
          ++roots;
        }
        ASSERT_EQ(roots, n) << trial;
        ASSERT_EQ(value_at(2, curve, coefficients), at_two) << n;
      }
    }
  }
}

TEST(RootGenerators, GiveEveryAxisTheSamePolynomial) {
  for (const GeneratorInfo& info : {MultipleRoot::info, ClusteredRoots::info}) {
    Trial trial;
    draw(1, 2, {Form::bernstein, 3, 4, 1, {}, std::string(info.id)}, 0, trial);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NE(trial.coefficients[3 * i], 0);
      EXPECT_EQ(trial.coefficients[3 * i + 1], trial.coefficients[3 * i]);
      EXPECT_EQ(trial.coefficients[3 * i + 2], trial.coefficients[3 * i]);
    }
    const std::vector<double> axis{trial.coefficients[0], trial.coefficients[3], trial.coefficients[6],
                                   trial.coefficients[9], trial.coefficients[12]};
    EXPECT_EQ(value_at(Exact(info.id == MultipleRoot::info.id ? 3 : 2, 4), Form::bernstein, axis), 0);
  }
}

}  // namespace
}  // namespace bezierbench::sample
