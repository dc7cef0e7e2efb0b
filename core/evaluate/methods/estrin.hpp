// SPDX-License-Identifier: MIT
// Formula: q_2k + q_(2k+1) t at every level: neighbours are joined with t, pairs with t^2, fours with t^4, and so on.
// Source: [Estrin 1960]; [Muller 2016], section 4.3.2.
// Cost: 2dn + log2 n flops per point, in a chain of log2 n steps instead of n.
// Bound: gamma_(n+2L) sum |q_j| |t|^j with L = ceil(log2(n+1)) levels: a coefficient meets at most L products and L
//   sums, and its power of t, formed by squaring, has at most n roundings. A power that underflows loses up to |q_j|
//   eta.
// Fails: as any power form, when its coefficients came out of a rounded conversion.
#pragma once

#include <bit>

#include "core/bound/amplification.hpp"
#include "core/evaluate/evaluator.hpp"

namespace bezierbench {

namespace detail {

/// `Size` coefficients from `first` on, joined. Size is a power of two, and powers[k] is t^(2^k).
template <int Size, class Scalar, class Coefficient>
[[gnu::always_inline]] inline Scalar joined_block(const Coefficient& q, int first, const Scalar* powers) {
  if constexpr (Size == 1) {
    return q(first);
  } else {
    constexpr int half = Size / 2;
    return joined_block<half>(q, first, powers) +
           joined_block<half>(q, first + half, powers) * powers[std::bit_width(static_cast<unsigned>(half)) - 1];
  }
}

/// Joins the last whole block of `Size` coefficients, if there is one that no larger block holds, with `rest`, what is
/// joined of the coefficients behind it.
template <int Size, class Scalar, class Coefficient>
[[gnu::always_inline]] inline void join_block(int count, const Coefficient& q, const Scalar* powers, Scalar& rest) {
  if ((count & Size) == 0) return;
  const Scalar block = joined_block<Size>(q, count & ~(2 * Size - 1), powers);
  rest = count % Size == 0 ? block : Scalar(block + rest * powers[std::bit_width(static_cast<unsigned>(Size)) - 1]);
}

/// The coefficients q(0), ..., q(count - 1) joined. `count` is a sum of powers of two, and Estrin's levels join a block of
/// each with what is joined of the smaller ones behind it. Blocks of up to sixteen are written out; of larger ones two
/// halves are joined as soon as both are there. The operands are those of the levels, and so are the bits.
template <class Scalar, class Coefficient>
[[gnu::always_inline]] inline Scalar joined(int count, const Coefficient& q, const Scalar& t) {
  constexpr int most = std::bit_width(static_cast<unsigned>(max_degree + 1));
  Scalar powers[most];
  powers[0] = t;
  for (int k = 0; k < 4; ++k) powers[k + 1] = count > 2 << k ? Scalar(powers[k] * powers[k]) : powers[k];
  Scalar rest = q(count - 1);
  join_block<2>(count, q, powers, rest);
  join_block<4>(count, q, powers, rest);
  join_block<8>(count, q, powers, rest);
  if (count < 16) return rest;
  if (count < 32) {
    join_block<16>(count, q, powers, rest);
    return rest;
  }
  for (int k = 5; 1 << k < count; ++k) powers[k] = powers[k - 1] * powers[k - 1];
  Scalar blocks[most];  // the k-th of 2^k coefficients
  for (int first = 0; first + 16 <= count; first += 16) {
    Scalar block = joined_block<16>(q, first, powers);
    int k = 4;
    for (; (first >> k & 1) != 0; ++k) block = blocks[k] + block * powers[k];
    blocks[k] = block;
  }
  for (int k = 4; count >> k != 0; ++k)
    if ((count >> k & 1) != 0) rest = count % (1 << k) == 0 ? blocks[k] : Scalar(blocks[k] + rest * powers[k]);
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
      .flops = "2dn + log2 n",
      .citation = "[Estrin 1960]"};

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis)
      p[axis] = detail::joined(
          curve.degree() + 1, [&](int i) { return curve(axis, i); }, t);
    return p;
  }
};

}  // namespace bezierbench
