// SPDX-License-Identifier: MIT
// Properties of every method, on polynomials whose roots are known or found exactly.
#include "core/roots/roster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <string_view>
#include <vector>

#include "core/evaluate/evaluation_test.hpp"
#include "core/roots/kernel.hpp"
#include "reference/companion/exact_roots.hpp"

namespace bezierbench {
namespace {

using Numbers = std::vector<double>;

CurveView<double> view(const Numbers& b) { return {Form::bernstein, 1, static_cast<int>(b.size()) - 1, b}; }

FoundRoots found_by(std::string_view id, const Numbers& b) {
  for (const auto& method : roots_kernels())
    if (method.info->id == id) return method.find(view(b), 0, 0);
  ADD_FAILURE() << id;
  return {};
}

/// Integer Bernstein coefficients of the product of (m t - k), for k in `zeros`: with x = t / (1-t) a factor is (m -
/// k) x - k, and b_i = e_i / C(n,i) for the coefficients e_i of the product, here times the least common multiple of
/// C(n,i).
Numbers with_roots(int m, const std::vector<int>& zeros) {
  std::vector<std::int64_t> e{1};
  for (const int k : zeros) {
    e.push_back(0);
    for (std::size_t i = e.size(); i-- > 0;) e[i] = -k * e[i] + (i > 0 ? (m - k) * e[i - 1] : 0);
  }
  const auto n = static_cast<int>(zeros.size());
  std::int64_t binomial = 1;
  std::int64_t common = 1;
  std::vector<std::int64_t> row;
  for (int i = 0; i <= n; ++i) {
    row.push_back(binomial);
    common = std::lcm(common, binomial);
    binomial = binomial * (n - i) / (i + 1);
  }
  Numbers b;
  for (std::size_t i = 0; i < e.size(); ++i) b.push_back(static_cast<double>(e[i] * (common / row[i])));
  return b;
}

void expect_roots(const FoundRoots& found, const Numbers& expected, double within, std::string_view who) {
  ASSERT_EQ(found.t.size(), expected.size()) << who;
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found.t[k], expected[k], within) << who;
}

template <class Use>
void each_that_takes(const Numbers& b, Use use) {
  for (const auto& method : roots_kernels())
    if (method.info->supports<double>(static_cast<int>(b.size()) - 1)) use(method);
}

/// Simple roots at k/8, ends among them. Errors are u times the condition, which is below 2^10 here, and 2^-45 of a
/// root of bezier_clipping. In power form the condition is up to 3^8 times as large.
TEST(Roots, SimpleRootsAreFoundByAll) {
  for (const std::vector<int>& zeros : {std::vector<int>{3},
                                        {2, 5},
                                        {0, 8},
                                        {1, 4, 7},
                                        {0, 3, 8},
                                        {3, 4, 5},
                                        {1, 2, 3, 5, 7},
                                        {0, 1, 2, 3, 4, 5, 6, 8}}) {
    const auto b = with_roots(8, zeros);
    Numbers expected;
    for (const int k : zeros) expected.push_back(k / 8.0);
    each_that_takes(b, [&](const RootsKernel& method) {
      const double within = method.info->id == "companion_eigenvalues" ? 0x1p-40 * 6561 : 0x1p-40;
      const auto found = method.find(view(b), 0, 0);
      expect_roots(found, expected, within, method.info->id);
      EXPECT_TRUE(std::ranges::all_of(found.enclosures, &RootEnclosure::certain)) << zeros.size();
    });
  }
}

/// Wilkinson's polynomial on [0, 1], with roots at k/n, the example of [Farouki and Rajan 1987], of fewer roots. All
/// coefficients are exact for n = 10; the condition of the roots in Bernstein form is below 1e6.
TEST(Roots, WilkinsonOnTheUnitInterval) {
  std::vector<int> zeros(10);
  std::iota(zeros.begin(), zeros.end(), 1);
  const auto b = with_roots(10, zeros);
  for (const double x : b) ASSERT_LT(std::abs(x), 0x1p53);
  Numbers expected;
  for (const int k : zeros) expected.push_back(k / 10.0);
  for (const auto* id : {"lane_riesenfeld", "bezier_clipping", "sampled_newton", "certified"})
    expect_roots(found_by(id, b), expected, 1e-9, id);
}

TEST(Roots, CurvesWithoutARootHaveNone) {
  for (const Numbers& b : {Numbers{1}, {1, 2}, {3, 1, 2}, {-1, -1, -2, -1}, {1, -0.5, 1}, {2, -1, 0.5, 1}}) {
    ASSERT_TRUE(reference::roots_of_value(view(b), 0, 0).roots.empty());
    each_that_takes(b, [&](const RootsKernel& method) {
      EXPECT_TRUE(method.find(view(b), 0, 0).t.empty()) << method.info->id << b.size();
    });
  }
}

/// a t^2 - 2 b t + c with Fibonacci numbers a, b, c = F_n, F_(n-1), F_(n-2) has the discriminant b^2 - a c = 1 for
/// even n ([Kahan 2004]) and the roots (b -+ 1) / a. For n = 40 the products have 54 bits, so that their difference
/// is lost to rounding; for n = 72 they have 100. Bernstein coefficients: c, c - b = -F_(n-3), a - 2 b + c = F_(n-4).
TEST(Roots, TheDiscriminantDoesNotCancel) {
  std::vector<std::int64_t> fibonacci{0, 1};
  while (fibonacci.size() <= 72) fibonacci.push_back(fibonacci.end()[-1] + fibonacci.end()[-2]);
  for (const std::size_t n : {40U, 72U}) {
    const auto f = [&](std::size_t k) { return static_cast<double>(fibonacci[n - k]); };
    expect_roots(found_by("closed_form", {f(2), -f(3), f(4)}), {(f(1) - 1) / f(0), (f(1) + 1) / f(0)}, 0x1p-52,
                 "Kahan");
  }
}

/// Double and triple roots of exact coefficients, where the closed forms have a case of their own: (4 t - 1)^2 (4 t -
/// 3), its mirror, (4 t - 1)^3, and (2 t - 1)^2.
TEST(Roots, ClosedFormsOfMultipleRoots) {
  expect_roots(found_by("closed_form", with_roots(4, {1, 1, 3})), {0.25, 0.75}, 0x1p-51, "double");
  expect_roots(found_by("closed_form", with_roots(4, {1, 3, 3})), {0.25, 0.75}, 0x1p-51, "double");
  expect_roots(found_by("closed_form", with_roots(4, {1, 1, 1})), {0.25}, 0, "triple");
  expect_roots(found_by("closed_form", with_roots(4, {1, 4, 4})), {0.25, 1}, 0x1p-52, "double at an end");
  expect_roots(found_by("closed_form", with_roots(4, {0, 0, 3})), {0, 0.75}, 0x1p-52, "double at an end");
  expect_roots(found_by("closed_form", with_roots(2, {1, 1})), {0.5}, 0, "double");
}

/// A control point on the axis is not a root, unless it is an end.
TEST(Roots, TheHullMayTouchTheAxis) {
  for (const Numbers& b : {Numbers{2, 3, 0, 3}, {-1, 0, -1}, {1, 0, 0, 2}})
    each_that_takes(
        b, [&](const RootsKernel& method) { EXPECT_TRUE(method.find(view(b), 0, 0).t.empty()) << method.info->id; });
}

/// A double root between samples is a cluster of `certified`, and no root of `sampled_newton`.
TEST(Roots, DoubleRoots) {
  const auto b = with_roots(100, {37, 37, 81});
  const auto found = found_by("certified", b);
  ASSERT_EQ(found.enclosures.size(), 2U);
  EXPECT_FALSE(found.enclosures[0].certain);
  EXPECT_LE(found.enclosures[0].low, 0.37);
  EXPECT_GE(found.enclosures[0].high, 0.37);
  EXPECT_LE(found.enclosures[0].high - found.enclosures[0].low, 0x1p-20);
  EXPECT_TRUE(found.enclosures[1].certain);
  EXPECT_NEAR(found.t[1], 0.81, 0x1p-48);
  expect_roots(found_by("sampled_newton", b), {0.81}, 0x1p-48, "sampled_newton");
}

/// Polynomials of many sizes with simple, near and multiple roots, on all of which promises must hold.
std::vector<Numbers> polynomials() {
  std::mt19937_64 words(1);  // its sequence is fixed by the standard
  const auto uniform = [&] { return static_cast<double>(words() >> 11U) * 0x1p-52 - 1; };
  std::vector<Numbers> all{{1, -2, 4},
                           {0, 0, 1},
                           {0, 0, -1, 0},
                           {0x1p-1074, -1, 1},
                           {0x1p-1074, -0x1p-1074, 0x1p-1074},
                           {0x1.8p1023, -0x1.8p1023, 0x1.8p1023, -0x1.8p1023},
                           {0x1.8p1023, 0x1p-1074, 0, -0x1p-1074},
                           {1, 0x1.0000000000001p0, -0x1.fffffffffffffp-1, 1}};
  for (int degree = 1; degree <= 9; ++degree)
    for (int k = 0; k < 60; ++k) {
      Numbers b;
      if (k % 2 == 0) {
        const double scale = std::ldexp(1, static_cast<int>(words() % 80) - 40);
        for (int i = 0; i <= degree; ++i) b.push_back(k % 4 == 0 ? std::floor(4 * uniform()) : scale * uniform());
      } else {
        std::vector<int> zeros;
        const int m = k % 4 == 1 ? 12 : 40;
        for (int i = 0; i < degree; ++i) zeros.push_back(m / 3 + static_cast<int>(words() % 5));
        b = with_roots(m, zeros);
      }
      if (std::ranges::any_of(b, [](double x) { return x != 0; })) all.push_back(std::move(b));
    }
  return all;
}

TEST(Roots, PromisesAreKept) {
  int certain = 0;
  for (const auto& b : polynomials())
    for (const double value : {0.0, 0.1}) {
      const auto truth = reference::roots_of_value(view(b), 0, value);
      each_that_takes(b, [&](const RootsKernel& method) {
        const auto found = method.find(view(b), 0, value);
        EXPECT_EQ(found.enclosures.empty(), method.info->promise.empty() || found.t.empty());
        if (method.info->promise.empty()) return;
        EXPECT_EQ(found.t.size(), found.enclosures.size());
        for (const auto& [t, multiplicity] : truth.roots)
          EXPECT_TRUE(std::ranges::any_of(found.enclosures, [&, at = t](const auto& one) {
            return one.low <= at && at <= one.high;
          })) << t;
        for (const auto& one : found.enclosures) {
          const auto within = [&](const auto& root) { return one.low <= root.t && root.t <= one.high; };
          if (!one.certain) continue;
          ++certain;
          EXPECT_EQ(std::ranges::count_if(truth.roots, within), 1);
        }
      });
    }
  EXPECT_GT(certain, 1000);
}

/// Values in [0, 1], ascending, of every method, whatever the polynomial.
TEST(Roots, AnswersAscendInTheInterval) {
  for (const auto& b : polynomials())
    each_that_takes(b, [&](const RootsKernel& method) {
      const auto found = method.find(view(b), 0, 0);
      EXPECT_TRUE(std::ranges::is_sorted(found.t)) << method.info->id;
      for (const double t : found.t) EXPECT_TRUE(t >= 0 && t <= 1) << method.info->id << t;
    });
}

/// The value is subtracted, and overflow avoided.
TEST(Roots, AxesAndValues) {
  const Numbers points{0, 5, 1, 3};  // of a line: x = t, y = 5 - 2 t
  const CurveView<double> line{Form::bernstein, 2, 1, points};
  const Numbers huge{-0x1.8p1023, 0x1.8p1023};
  for (const auto& method : roots_kernels()) {
    expect_roots(method.find(line, 0, 0.25), {0.25}, 0x1p-44, method.info->id);
    expect_roots(method.find(line, 1, 4), {0.5}, 0x1p-44, method.info->id);
    expect_roots(method.find(view(huge), 0, 0x1.2p1023), {0.875}, 0x1p-44, method.info->id);
  }
}

/// The scale of a curve does not matter, and zeros at an end are divided out at every scale: by binomials that would
/// make the largest doubles overflow.
TEST(Roots, DoNotDependOnTheScale) {
  Inputs inputs(31);
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 1 + trial % 40;
    auto b = inputs.coefficients(n, 1);
    if (trial % 3 == 0) b.front() = 0;
    if (trial % 3 == 1) b.back() = 0;
    if (trial % 6 == 0 && n > 1) b[1] = 0;
    for (const auto& method : roots_kernels()) {
      if (!method.info->supports<double>(n)) continue;
      const auto found = method.find(view(b), 0, 0);
      for (const double scale : {0x1p-500, 0x1p+900, 0x1p+1023}) {
        auto scaled = b;
        for (double& x : scaled) x *= scale;
        EXPECT_EQ(method.find(view(scaled), 0, 0).t, found.t) << method.info->id << " degree " << n;
      }
    }
  }
}

}  // namespace
}  // namespace bezierbench
