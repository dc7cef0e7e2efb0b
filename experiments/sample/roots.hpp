// SPDX-License-Identifier: MIT
// Generators of polynomials with given roots.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "experiments/sample/independent_points.hpp"

namespace bezierbench::sample {

// Generator `multiple_root`: p(t) = R (t - 3/4)^n, whose condition number grows without limit as t nears 3/4.
//
// With 3/4 = 3 * 2^-2 the coefficients are integers times powers of two,
//   Bernstein form   b_i = R (-3/4)^(n-i) (1/4)^i = R (-3)^(n-i) 4^-n
//   power form       q_j = R C(n,j) (-3/4)^(n-j)  = R C(n,j) (-3)^(n-j) 4^(j-n)
// and doubles, exactly, as long as 3^n and the odd parts of C(n,j) 3^(n-j) are below 2^53: through n = 33 and n = 27.
//
// Condition number p~/|p| at t in [0, 1], exactly:
//   Bernstein form   ((t + 3 (1-t)) / (4 |t - 3/4|))^n    (3/8 / d)^n  at t = 3/4 -+ d, to first order in d
//   power form       ((t + 3/4) / |t - 3/4|)^n            (3/2 / d)^n
// Jiang, Li, Cheng and Su 2010 and Hermes 2019, section 5, test compensated schemes with (t - 1)(t - 3/4)^7.

/// Takes two words, for t: all trials of a cell have the same polynomial.
struct MultipleRoot {
  static constexpr GeneratorInfo info{.id = "multiple_root",
                                      .coordinates = "those of R (t - 3/4)^n on every axis, exact; R a power of two",
                                      .t = "as continuous",
                                      .limits = {.whole_curve = true,
                                                 .bezier_degree = 33,
                                                 .polynomial_degree = 27,
                                                 .smallest_range = 0x1p-900,
                                                 .largest_range = 0x1p900,
                                                 .exact_coefficients = true}};

  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }

  static void polynomial(Words& /*words*/, Form curve, std::span<double> coefficients) {
    const int n = static_cast<int>(coefficients.size()) - 1;
    const bool power = curve == Form::power;
    std::int64_t integer = 1;  // (-3)^k, in power form times C(n,k), of coefficient n - k
    for (int k = 0; k <= n; ++k) {
      coefficients[static_cast<std::size_t>(n - k)] = std::ldexp(static_cast<double>(integer), -2 * (power ? k : n));
      integer *= -3;
      if (power) integer = integer * (n - k) / (k + 1);  // exact: k + 1 divides C(n,k) (n - k)
    }
  }
};

// Generator `clustered_roots`: p(t) = R lambda (t - r_1) ... (t - r_n) with n simple roots close to 1/2.
//
// The roots are r = a / 2^m for integers a = 2^(m-1) + k: one at 1/2 (k = 0), the others at distinct k with
// 0 < |k| <= n. With L the least common multiple of all C(n,i),
//   Bernstein form   b_i = R lambda e_i / (C(n,i) 2^(mn)),    e_i the coefficients of prod ((2^m - a) x - a)
//   power form       q_j = R lambda s_j 2^(mj - mn),          s_j the coefficients of prod (x - a)
// (substitute x = t / (1-t) and x = 2^m t), where lambda = L / 2^ceil(log2 L) makes all of them integers times powers
// of two. Those integers, L e_i / C(n,i) and L s_j, are at most L (2^(m-1) + n)^n in magnitude: |e_i| / C(n,i) is at
// most a mean of products of n numbers a or 2^m - a, and |s_j| <= C(n,j) max(a)^(n-j) <= max(a)^n, as n <= max(a). m is
// the largest for which that is at most 2^53, so that every coefficient is a double, exactly, and the cluster as tight
// as doubles allow: m = 10 for n = 5, 6 for n = 8.
//
// Degrees end at 8: from 9 on the cluster [1/2 - n 2^-m, 1/2 + n 2^-m] takes up more than half of [0, 1].
//
// Condition number at 1/2 -+ d: about (2d)^-n in Bernstein form and d^-n in power form for a d that is large against
// the cluster, as for an n-fold root; far inside it grows like 1/d only, as for the simple root at 1/2.

/// Takes two words for t, then two for each root except the one at 1/2.
struct ClusteredRoots {
  static constexpr int largest_degree = 8;

  static constexpr GeneratorInfo info{
      .id = "clustered_roots",
      .coordinates =
          "those of a polynomial with n simple roots on a lattice about 1/2, on every axis, exact; R a power "
          "of two",
      .t = "as continuous",
      .limits = {.whole_curve = true,
                 .bezier_degree = largest_degree,
                 .polynomial_degree = largest_degree,
                 .smallest_range = 0x1p-900,
                 .largest_range = 0x1p900,
                 .exact_coefficients = true}};

  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }

  static void polynomial(Words& words, Form curve, std::span<double> coefficients) {
    const int n = static_cast<int>(coefficients.size()) - 1;
    const int m = lattice_bits(n);
    const bool power = curve == Form::power;
    const std::int64_t one = std::int64_t{1} << m;
    const auto offsets = draw_offsets(words, n);
    std::array<std::int64_t, largest_degree + 1> product{1};  // the factors multiplied so far, ascending in x
    for (int k = 0; k < n; ++k) {
      const std::int64_t a = one / 2 + offsets[index(k)];
      const std::int64_t slope = power ? 1 : one - a;
      for (int i = k + 1; i >= 0; --i) {
        product[index(i)] = (i > 0 ? slope * product[index(i - 1)] : 0) - a * product[index(i)];
      }
    }
    const std::uint64_t multiple = common_multiple(n);
    const int unit = -(m * n) - static_cast<int>(std::bit_width(multiple - 1));
    for (int i = 0; i <= n; ++i) {
      const auto share = static_cast<std::int64_t>(multiple / (power ? 1 : binomial(n, i)));
      coefficients[index(i)] = std::ldexp(static_cast<double>(share * product[index(i)]), unit + (power ? m * i : 0));
    }
  }

  /// The m for degree n: the largest up to 53 with L (2^(m-1) + n)^n <= 2^53.
  static constexpr int lattice_bits(int n) {
    int m = 53;
    while (m > 1 && !fits(n, m)) --m;
    return m;
  }

 private:
  static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

  static constexpr std::uint64_t binomial(int n, int i) {
    std::uint64_t value = 1;
    for (int k = 1; k <= i; ++k) value = value * static_cast<std::uint64_t>(n - k + 1) / static_cast<std::uint64_t>(k);
    return value;
  }

  static constexpr std::uint64_t common_multiple(int n) {
    std::uint64_t multiple = 1;
    for (int i = 0; i <= n; ++i) multiple = std::lcm(multiple, binomial(n, i));
    return multiple;
  }

  static constexpr bool fits(int n, int m) {
    constexpr std::uint64_t limit = std::uint64_t{1} << 53U;
    const std::uint64_t largest = (std::uint64_t{1} << static_cast<unsigned>(m - 1)) + static_cast<std::uint64_t>(n);
    std::uint64_t bound = common_multiple(n);
    for (int k = 0; k < n; ++k) {
      if (bound > limit / largest) return false;
      bound *= largest;
    }
    return true;
  }

  /// 0, then n - 1 distinct numbers of -n, ..., -1, 1, ..., n: the first ones of a Fisher-Yates shuffle.
  static std::array<std::int64_t, largest_degree> draw_offsets(Words& words, int n) {
    std::array<std::int64_t, std::size_t{2} * largest_degree> sites{};
    for (int k = 0; k < n; ++k) {
      sites[index(k)] = k - n;
      sites[index(n + k)] = k + 1;
    }
    std::array<std::int64_t, largest_degree> offsets{};
    for (int k = 1; k < n; ++k) {
      const auto left = static_cast<std::uint64_t>(2 * n - (k - 1));
      std::swap(sites[index(k - 1)], sites[index(k - 1) + words.next_below(left)]);
      offsets[index(k)] = sites[index(k - 1)];
    }
    return offsets;
  }
};

}  // namespace bezierbench::sample
