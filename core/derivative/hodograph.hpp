// SPDX-License-Identifier: MIT
// Formula: C^(k)(t) = sum h_i B_i,n-k(t) with h_i = (n)_k D^k b_i. The k-th derivative is a Bezier curve of degree n -
//   k, the k-th hodograph, and every evaluator takes it.
// Source: [Farin 2002], higher order derivatives; [Document 000], eq. (6).
// Cost: d k (2n - k + 1)/2 + d (n-k+1) + k flops once, then the evaluator's for degree n - k.
// Bound: k differences cost gamma_k A, the product with (n)_k and its k - 1 roundings gamma_k of the result. The
//   evaluator works on these coefficients with a bound of its own, gamma_e of their p~. Together
//     gamma_k (1 + gamma_k) (1 + gamma_e) A + (gamma_k + gamma_e + gamma_k gamma_e) p~.
//   Differences cannot underflow; each product with (n)_k may, by eta/2.
// Fails: where points are of similar size and their differences small but inexact, A is far above p~.
#pragma once

#include <algorithm>

#include "core/derivative/derivative.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/factorial.hpp"

namespace bezierbench {

namespace detail {

/// D^k b_i from D^(k-1) b_i, for i up to n - k.
template <class Scalar, int Dimension, int Degree>
void take_differences(Curve<Form::bernstein, Scalar, Dimension, Degree>& b, int k) {
  for (int i = 0; i <= b.degree() - k; ++i)
    for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = b(axis, i + 1) - b(axis, i);
}

/// (n)_k D^k b_i from D^k b_i, k = `order`; a single point, 0, for orders beyond the degree.
template <class Scalar, int Dimension, int Degree>
Curve<Form::bernstein, Scalar, Dimension> scaled_differences(
    const Curve<Form::bernstein, Scalar, Dimension, Degree>& difference, int order) {
  const int n = difference.degree();
  Curve<Form::bernstein, Scalar, Dimension> result(std::max(n - order, 0));
  const auto factor = static_cast<Scalar>(falling_factorial(n, order));
  for (int i = 0; i <= result.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) result(axis, i) = order > n ? Scalar(0) : factor * difference(axis, i);
  return result;
}

}  // namespace detail

/// The control points of the derivative of this order; a single point, 0, for orders beyond the degree.
template <class Scalar, int Dimension, int Degree>
Curve<Form::bernstein, Scalar, Dimension> hodograph(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve,
                                                    int order) {
  auto difference = curve;
  for (int k = 1; k <= std::min(order, curve.degree()); ++k) detail::take_differences(difference, k);
  return detail::scaled_differences(difference, order);
}

/// All members of a method except `info`: differences, then the evaluator `E` on the hodograph.
template <Evaluator E>
struct HodographBy {
  static_assert(E::info.bound->amplification == Amplification::p_tilde_bernstein &&
                    E::info.bound->result_roundings == 0,
                "the bound is derived for evaluators of the Bernstein form that are not compensated");

  template <class Scalar, int Dimension, int Degree>
  static PreparedOf<E, Scalar, Dimension> prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve,
                                                  int order) {
    return E::prepare(hodograph(curve, order));
  }

  template <class Prepared, class Scalar>
  static auto evaluate(const Prepared& prepared, Scalar t) {
    return E::evaluate(prepared, t);
  }

  template <class Scalar, int Dimension, int Degree, class Take>
  static void all(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, int last_order, const Scalar& t,
                  Take take) {
    auto difference = curve;
    for (int k = 0; k <= last_order; ++k) {
      if (k > 0) detail::take_differences(difference, k);
      take(k, E::evaluate(E::prepare(detail::scaled_differences(difference, k)), t));
    }
  }

  static constexpr DerivativeBound bound_as(std::string_view text) {
    return {.text = text,
            .differences =
                [](int n, int k, double u) {
                  const double gamma_k = gamma_over_u(std::min(n, k), u);
                  return gamma_k * (1 + u * gamma_k) * (1 + u * evaluator_factor(n, k, u));
                },
            .evaluation =
                [](int n, int k, double u) {
                  const double gamma_k = gamma_over_u(std::min(n, k), u);
                  const double gamma_e = evaluator_factor(n, k, u);
                  return gamma_k + gamma_e + u * gamma_k * gamma_e;
                },
            .underflow = [](int n, int k) { return E::info.bound->underflow(std::max(n - k, 0)) + 1; },
            .underflow_scales_with_coefficients = E::info.bound->underflow_scales_with_coefficients,
            .growth = [](int n, int k) { return E::info.bound->growth(std::max(n - k, 0)); }};
  }

 private:
  static constexpr double evaluator_factor(int n, int k, double u) {
    return E::info.bound->factor(std::max(n - k, 0), u);
  }
};

}  // namespace bezierbench
