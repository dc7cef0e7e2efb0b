// SPDX-License-Identifier: MIT
// Formula: q_2k + q_(2k+1) t at every level: neighbours are joined with t, pairs with t^2, fours with t^4, and so on.
// Source: [Estrin 1960]; [Muller 2016], section 4.3.2.
// Cost: at most 2dn + log2 n flops per point, in a chain of log2 n steps instead of n.
// Bound: gamma_(n+2L) sum |q_j| |t|^j with L = ceil(log2(n+1)) levels: a coefficient meets at most L products and L
//   sums, and its power of t, formed by squaring, has at most n roundings. A power that underflows loses up to |q_j|
//   eta.
// Fails: as any power form, when its coefficients came out of a rounded conversion.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "core/bound/amplification.hpp"
#include "core/evaluate/evaluator.hpp"

namespace bezierbench {

namespace detail {

/// A coefficient with several axes, which share the powers of t.
template <class Scalar, std::size_t Axes>
struct OnAxes {
  std::array<Scalar, Axes> values;

  [[gnu::always_inline]] friend OnAxes operator+(const OnAxes& a, const OnAxes& b) {
    OnAxes sum;
    for (std::size_t axis = 0; axis < Axes; ++axis) sum.values[axis] = a.values[axis] + b.values[axis];
    return sum;
  }
  [[gnu::always_inline]] friend OnAxes operator*(const OnAxes& a, const Scalar& power) {
    OnAxes product;
    for (std::size_t axis = 0; axis < Axes; ++axis) product.values[axis] = a.values[axis] * power;
    return product;
  }
};

/// `Size` coefficients from `first` on, joined. Size is a power of two, and powers[k] is t^(2^k).
template <int Size, class Scalar, class Coefficient>
[[gnu::always_inline]] inline auto joined_block(const Coefficient& q, int first, const Scalar* powers) {
  if constexpr (Size == 1) {
    return q(first);
  } else {
    constexpr int half = Size / 2;
    return joined_block<half>(q, first, powers) +
           joined_block<half>(q, first + half, powers) * powers[std::bit_width(static_cast<unsigned>(half)) - 1];
  }
}

/// Joins at least 32 coefficients: blocks of sixteen, two halves of a larger block as soon as both are there, and
/// `rest`, what is joined of the count % 16 coefficients behind them. powers[k] is t^(2^k).
template <class Scalar, class Coefficient, class Value>
[[gnu::always_inline]] inline Value joined_blocks(int count, const Coefficient& q,
                                                  const std::array<Scalar, 5>& first_powers, Value rest) {
  constexpr int most = std::bit_width(static_cast<unsigned>(max_degree + 1));
  Scalar powers[most];
  std::copy(first_powers.begin(), first_powers.end(), powers);
  for (int k = 5; 1 << k < count; ++k) powers[k] = powers[k - 1] * powers[k - 1];
  Value blocks[most];  // the k-th of 2^k coefficients
  Value pair = rest;   // of the first 32, which wait for no memory where they are all that is left
  for (int first = 0; first + 16 <= count; first += 16) {
    Value block = joined_block<16>(q, first, powers);
    if (count < 64) {
      if (first == 32)
        rest = count == 48 ? block : block + rest * powers[4];
      else
        pair = first == 0 ? block : pair + block * powers[4];
      continue;
    }
    int k = 4;
    for (; (first >> k & 1) != 0; ++k) block = blocks[k] + block * powers[k];
    blocks[k] = block;
  }
  if (count < 64) return count == 32 ? pair : pair + rest * powers[5];
  for (int k = 4; count >> k != 0; ++k)
    if ((count >> k & 1) != 0) rest = count % (1 << k) == 0 ? blocks[k] : blocks[k] + rest * powers[k];
  return rest;
}

/// The coefficients q(0), ..., q(count - 1) joined. `count` is a sum of powers of two, and Estrin's levels join a block
/// of each with what is joined of the smaller ones behind it, which is `rest` for those below 2^K. powers[k] is
/// t^(2^k). The operands are those of the levels, and so are the bits.
template <std::size_t K, class Scalar, class Coefficient, class Value>
[[gnu::always_inline]] inline Value joined(int count, const Coefficient& q, const std::array<Scalar, K + 1>& powers,
                                           Value rest) {
  constexpr int size = 1 << K;
  if constexpr (size == 16)
    if (count >= 2 * size) return joined_blocks(count, q, powers, rest);
  if ((count & size) != 0) {
    const Value block = joined_block<size>(q, count & ~(2 * size - 1), powers.data());
    rest = count % size == 0 ? block : block + rest * powers[K];
  }
  if constexpr (size < 16)
    if (count >= 2 * size) {
      if (count == 2 * size) return joined_block<2 * size>(q, 0, powers.data());
      std::array<Scalar, K + 2> more;
      for (std::size_t k = 0; k <= K; ++k) more[k] = powers[k];
      more[K + 1] = powers[K] * powers[K];
      return joined<K + 1>(count, q, more, rest);
    }
  return rest;
}

}  // namespace detail

struct Estrin : TakenAsGiven<Form::power> {
  static constexpr int levels(int n) {
    int count = 0;
    while ((1 << count) < n + 1) ++count;
    return count;
  }

  static constexpr MethodInfo info{
      .id = "estrin",
      .label = "Estrin",
      .form = Form::power,
      .bound = ErrorBound{.text = "gamma_(n+2L) p~, L = ceil(log2(n+1))",
                          .amplification = Amplification::p_tilde_power,
                          .factor = [](int n, double u) { return gamma_over_u(n + 2 * levels(n), u); },
                          .underflow = [](int n) { return 4.0 * (n + 1) * (n + 1); },
                          .underflow_scales_with_coefficients = true,
                          .growth = [](int n) { return n + 1.0; }},
      .flops = "at most 2dn + log2 n",
      .citation = "[Estrin 1960]"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 3};

  static constexpr int largest_fixed_degree = 16;  ///< beyond, to take the degree apart costs little

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    const auto q = [&curve](int i) {
      if constexpr (Dimension == 1) {
        return curve(0, i);
      } else {
        detail::OnAxes<Scalar, Dimension> coefficient;
        for (int axis = 0; axis < Dimension; ++axis)
          coefficient.values[static_cast<std::size_t>(axis)] = curve(axis, i);
        return coefficient;
      }
    };
    const auto joined = detail::joined<0>(n + 1, q, std::array<Scalar, 1>{t}, q(n));
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis)
      if constexpr (Dimension == 1)
        p[axis] = joined;
      else
        p[axis] = joined.values[static_cast<std::size_t>(axis)];
    return p;
  }
};

}  // namespace bezierbench
