// SPDX-License-Identifier: MIT
// Formula: z = t (1-t) and L_j = (1-t) s_j + t s_(n-j); from c = L_m, n = 2m+1, or c = L_(m-1) + z s_m, n = 2m:
//   c = L_j + z (c - L_j) for j = m-1 (odd n) or m-2 (even n), ..., 0. A cubic has s_0 = b_0, s_1 = 3 b_1 - b_0 - b_3,
//   s_2 = 3 b_2 - b_3 - b_0, s_3 = b_3, and takes three linear interpolations.
// Source: higher degrees than the cubic are derived here: p = sum z^j ((1-t) a_j + t a_(n-j)) is the symmetric power
//   form of [Sanchez-Reyes 1997]; s_j = a_0 + ... + a_j makes it interpolations.
// Cost: O(d) memory; `prepare` takes about (1 + d) n^2/2.
// Bound: gamma_(4n+6) (1+sqrt 2)^n (1/2 + |t-1/2|)^n sum C(n,k) |b_k| on [0,1], and n more roundings past n = 54.
//   docs/proofs/seiler.md derives it, the coefficients s_j and what the method keeps.
// Keeps: ends_exact, axes_independent, scaling_by_two, total; reversal and finite for n = 1.
// Fails: constants are lost to rounding. The points s_j grow like 2.2^n, and their rounding costs a factor of 1.41^n at
//   t = 1/2, where z^j takes most of it back.
#pragma once

#include <tuple>

#include "core/binomial.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/schemes/steps.hpp"
#include "core/powers.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

struct Seiler : SameForEveryAxis {
  static constexpr MethodInfo info{
      .id = "seiler",
      .label = "Seiler's interpolation",
      .form = Form::bernstein,
      .max_degree = 850,
      .max_degree_float = 95,
      .bound = ErrorBound{.text = "gamma_(4n+6) (1+sqrt 2)^n (1/2+|t-1/2|)^n sum C(n,k) |b_k| on [0,1], and n more "
                                  "roundings past n = 54",
                          .amplification = Amplification::bernstein_to_centered,
                          .factor =
                              [](int n, double u) {
                                constexpr double one_and_root_of_two = 2.4142135623730954;  // rounded up
                                return gamma_over_u(4 * n + 6 + binomial_roundings(n, u), u) *
                                       integer_power(one_and_root_of_two, n);
                              },
                          .underflow = [](int n) { return 2.0 * (n + 3); },
                          .growth = [](int n) { return 3 * integer_power(2.2360679774997899, n); },
                          .unit_interval_only = true},
      .flops = "3dn + 2, d fewer for even n",
      .prepare_exponent = 2,
      .citation = "[Lin et al. 2021]; [Yuksel 2024]; [Sanchez-Reyes 1997], for higher degrees"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 3};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact},       Guarantee{Property::reversal, 1},
                                         Guarantee{Property::finite, 1},        Guarantee{Property::scaling_by_two},
                                         Guarantee{Property::axes_independent}, Guarantee{Property::total}};

  static constexpr int largest_fixed_degree = 16;  ///< beyond, to enter its steps costs little

  /// Column j holds s_j.
  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::bernstein, Scalar, Dimension, Degree> seiler;

    [[nodiscard]] auto parts() const { return std::tie(seiler); }
  };

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    constexpr int computed = computed_degree<Degree>;
    const int n = curve.degree();
    const int pairs = (n + 1) / 2;
    const BinomialRow<Scalar, computed> binomial(n);
    Prepared<Scalar, Dimension, computed> prepared{Curve<Form::bernstein, Scalar, Dimension, computed>(n)};
    auto& s = prepared.seiler;
    for (int axis = 0; axis < Dimension; ++axis) {
      for (int j = 0; j <= n; ++j) s(axis, j) = Scalar(0);
      for (int k = 0; 2 * pairs == n && k <= n; ++k) {
        const Scalar term = curve(axis, k) * binomial[k];
        s(axis, pairs) = (n - pairs - k) % 2 == 0 ? Scalar(s(axis, pairs) + term) : Scalar(s(axis, pairs) - term);
      }
    }
    auto last = per_coefficient<double, computed>(n);  // S(length - 1)
    auto row = per_coefficient<double, computed>(n);   // S(length)
    for (int i = 0; i < pairs; ++i) {
      last[i] = 0;
      row[i] = 1;
    }
    for (int length = 1; length <= n + 1; ++length) {
      const int k = (n + 1 - length) / 2;
      if (2 * k + length == n + 1 && k < pairs) {
        for (int axis = 0; axis < Dimension; ++axis) {
          Scalar own = curve(axis, k) * binomial[k];
          Scalar mirrored = curve(axis, n - k) * binomial[k];
          if (k > 0) {
            own = own - curve(axis, n + 1 - k) * binomial[k - 1];
            mirrored = mirrored - curve(axis, k - 1) * binomial[k - 1];
          }
          for (int j = k; j < pairs; ++j) {
            const auto weight = static_cast<SharedBy<Scalar>>(row[j - k]);
            s(axis, j) = s(axis, j) + own * weight;
            s(axis, n - j) = s(axis, n - j) + mirrored * weight;
          }
        }
      }
      for (int i = pairs - 1; i >= 0; --i) {
        const double next = i > 0 ? row[i] - last[i - 1] : row[i];
        last[i] = row[i];
        row[i] = next;
      }
    }
    return prepared;
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    const auto& s = prepared.seiler;
    const int n = s.degree();
    const Scalar rest = Scalar(1) - t;
    const Scalar z = t * rest;
    Point<Scalar, Dimension> c;
    if (n == 0) {
      for (int axis = 0; axis < Dimension; ++axis) c[axis] = s(axis, 0);
      return c;
    }
    const int middle = (n - 1) / 2;
    for (int axis = 0; axis < Dimension; ++axis) {
      c[axis] = rest * s(axis, middle) + t * s(axis, n - middle);
      if (n % 2 == 0) c[axis] = c[axis] + z * s(axis, n / 2);
    }
    count_down<Scalar, Degree>(middle - 1, [&](int j) {
      for (int axis = 0; axis < Dimension; ++axis) {
        const Scalar line = rest * s(axis, j) + t * s.from_end(axis, j);
        c[axis] = line + z * (c[axis] - line);
      }
    });
    return c;
  }
};

}  // namespace bezierbench
