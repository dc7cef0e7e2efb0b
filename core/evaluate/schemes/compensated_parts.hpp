// SPDX-License-Identifier: MIT
// Schemes in K parts: v_0 is computed as usual, v_F from the errors of v_(F-1), and the sum of the parts is the result.
// What their bounds and their last step have in common; compensated_triangle.hpp and compensated_horner_parts.hpp have
// the steps and derive the bounds.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/bound/error_bound.hpp"
#include "core/error_free.hpp"

namespace bezierbench {

namespace detail {

/// The text for a scheme of K = 2, 3 or 4 parts.
template <int K>
constexpr std::string_view for_parts(std::string_view two, std::string_view three, std::string_view four) {
  return K == 2 ? two : K == 3 ? three : four;
}

}  // namespace detail

/// Magnitudes in a scheme of K parts.
template <int K>
struct PartSizes {
  std::array<double, static_cast<std::size_t>(K)> parts;  ///< V_F / (u^F p~)
  double dropped;                                         ///< sum of L_K / (u^K p~)
};

/// `sizes` after n more steps. With V_F and L_F the sums of |v_F| and of the magnitudes of the errors that go into it,
/// weighted as what they become in p,
///   L_1     <= gamma_r V_0
///   V_F     <= (1 + gamma_r) V_F + (1 + gamma_e(F)) L_F
///   L_(F+1) <= gamma_e(F) L_F + gamma_r V_F
/// in every step, where r = `value_roundings` and e = `error_roundings`; L_K is dropped.
template <int K, class Roundings>
constexpr PartSizes<K> after_steps(int n, double u, PartSizes<K> sizes) {
  const double value_gamma = gamma_over_u(Roundings::value_roundings, u);
  auto& size = sizes.parts;
  for (int m = 1; m <= n; ++m) {
    double local = value_gamma * size[0];  // L_(F+1) / (u^(F+1) p~)
    size[0] *= 1 + value_gamma * u;
    for (int part = 1; part < K; ++part) {
      const auto f = static_cast<std::size_t>(part);
      const double gamma = gamma_over_u(Roundings::error_roundings(part), u);
      const double next = gamma * local + value_gamma * size[f];
      size[f] = (1 + value_gamma * u) * size[f] + (1 + gamma * u) * local;
      local = next;
    }
    sizes.dropped += local;
  }
  return sizes;
}

/// The remainder of the bound of K parts after n steps, over p~ and without underflow:
/// (|computed - p| - (u + 3 gamma_(K-1)^2) |p|) / p~ is at most this. V_0 begins as the bound of `ahead` steps.
template <int K, class Roundings>
constexpr double remainder_of_parts(int n, double u) {
  PartSizes<K> first{{1}, 0};
  for (int m = 0; m < Roundings::ahead; ++m) first.parts[0] *= 1 + gamma_over_u(Roundings::value_roundings, u) * u;
  const auto sizes = after_steps<K, Roundings>(n, u, first);
  double power = 1;  // u^K
  double sum = 0;
  for (const double each : sizes.parts) {
    sum += each * power;
    power *= u;
  }
  double adding = K > 2 ? sum : 0;
  for (int part = 0; part < K; ++part) adding *= gamma_over_u(2 * K - 2, u);
  return (sizes.dropped * (1 + 2 * u) + adding) * power;
}

template <int K, class Roundings>
constexpr ErrorBound bound_of_parts(std::string_view text, Amplification amplification, double (*underflow)(int),
                                    double (*growth)(int)) {
  return {.text = text,
          .amplification = amplification,
          .factor =
              [](int n, double u) {
                const double adding = K > 2 ? gamma_over_u(K - 1, u) : 0;
                return remainder_of_parts<K, Roundings>(n, u) / u + 3 * adding * adding * u;
              },
          .underflow = underflow,
          .growth = growth,
          .result_roundings = 1};
}

/// total <- total + term; returns the error.
template <class Scalar>
Scalar accumulate(Scalar& total, const Scalar& term) {
  const auto sum = two_sum<Scalar>(total, term);
  total = sum.value;
  return sum.error;
}

/// The sum of K parts as if in K-fold precision, rounded once: [Ogita et al. 2005], Algorithm 4.8.
template <std::size_t K, class Scalar>
Scalar sum_of_parts(std::array<Scalar, K> parts) {
  for (std::size_t pass = 1; pass < K; ++pass)
    for (std::size_t k = K - 1; k > 0; --k) {
      const auto sum = two_sum<Scalar>(parts[k - 1], parts[k]);
      parts[k - 1] = sum.value;
      parts[k] = sum.error;
    }
  Scalar tail = parts[K - 1];
  for (std::size_t k = K - 2; k > 0; --k) tail = tail + parts[k];
  return parts[0] + tail;
}

}  // namespace bezierbench
