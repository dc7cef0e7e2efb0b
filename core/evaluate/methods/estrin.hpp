// SPDX-License-Identifier: MIT
// Formula: q_2k + q_(2k+1) t at every level: neighbours are joined with t, pairs with t^2, fours with t^4, and so on.
// Source: [Muller 2016], section 4.3.2.
// Cost: a chain of log2 n steps instead of n.
// Bound: gamma_(n+2L) sum |q_j| |t|^j with L = ceil(log2(n+1)) levels: a coefficient meets at most L products and L
//   sums, and its power of t, formed by squaring, has at most n roundings. A power that underflows loses up to |q_j|
//   eta.
// Fails: as any power form, when its coefficients came out of a rounded conversion.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>

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

/// The coefficients q(0), ..., q(Count - 1) joined: those of the largest power of two below `Count`, and the others
/// with the power of t between the two. powers[k] is t^(2^k), wherever it is used.
template <int Count, class Scalar, class Coefficient>
[[gnu::always_inline]] inline auto joined(const Coefficient& q, const Scalar* powers) {
  if constexpr (Count == 1) {
    return q(0);
  } else {
    constexpr int k = std::bit_width(static_cast<unsigned>(Count - 1)) - 1;
    return joined<1 << k>(q, powers) +
           joined<Count - (1 << k)>([&q](int i) { return q(i + (1 << k)); }, powers) * powers[k];
  }
}

/// The last `count` < 16 coefficients joined, from_end(0) being the last one; anything for 0. Each count has code of
/// its own.
template <class Scalar, class Coefficient>
[[gnu::always_inline]] inline auto joined_end(int count, const Coefficient& from_end, const Scalar* powers) {
  const auto last = [&]<int Count>(std::integral_constant<int, Count> /*count*/) {
    return joined<Count>([&from_end](int i) { return from_end(Count - 1 - i); }, powers);
  };
  switch (count) {
    case 2: return last(std::integral_constant<int, 2>());
    case 3: return last(std::integral_constant<int, 3>());
    case 4: return last(std::integral_constant<int, 4>());
    case 5: return last(std::integral_constant<int, 5>());
    case 6: return last(std::integral_constant<int, 6>());
    case 7: return last(std::integral_constant<int, 7>());
    case 8: return last(std::integral_constant<int, 8>());
    case 9: return last(std::integral_constant<int, 9>());
    case 10: return last(std::integral_constant<int, 10>());
    case 11: return last(std::integral_constant<int, 11>());
    case 12: return last(std::integral_constant<int, 12>());
    case 13: return last(std::integral_constant<int, 13>());
    case 14: return last(std::integral_constant<int, 14>());
    case 15: return last(std::integral_constant<int, 15>());
    default: return last(std::integral_constant<int, 1>());
  }
}

/// `count` coefficients joined, q(0) being the first and from_end(0) the last one: blocks of sixteen, two halves of a
/// larger block as soon as both are there, and behind them the other count % 16. The operands are those of Estrin's
/// levels, and so are the bits.
template <class Scalar, class Coefficient, class FromEnd>
[[gnu::always_inline]] inline auto joined(int count, const Coefficient& q, const FromEnd& from_end, const Scalar& t) {
  constexpr int most = std::bit_width(static_cast<unsigned>(max_degree + 1));
  Scalar powers[most];
  powers[0] = t;
  const auto square = [&powers](int k) { powers[k] = powers[k - 1] * powers[k - 1]; };
  for (int k = 1; k < 4; ++k) {
    powers[k] = t;  // nothing reads it; compilers do not see that
    if (count >= 16 || 1 << k < count) square(k);
  }
  const int others = count % 16;
  auto end = joined_end<Scalar>(others, from_end, powers);
  if (count < 16) return end;
  const auto block = [&](int first) { return joined<16, Scalar>([&q, first](int i) { return q(first + i); }, powers); };
  if (count == 16) return block(0);
  square(4);
  if (count < 32) return block(0) + end * powers[4];
  if (count < 64) {
    const auto pair = block(0) + block(16) * powers[4];
    if (count == 32) return pair;
    square(5);
    if (count < 48) return pair + end * powers[5];
    const auto third = block(32);
    return pair + (others == 0 ? third : third + end * powers[4]) * powers[5];
  }
  for (int k = 5; 1 << k < count; ++k) square(k);
  decltype(end) blocks[most];  // the k-th of 2^k coefficients
  for (int first = 0; first + 16 <= count; first += 16) {
    auto whole = block(first);
    int k = 4;
    for (; (first >> k & 1) != 0; ++k) whole = blocks[k] + whole * powers[k];
    blocks[k] = whole;
  }
  for (int k = 4; count >> k != 0; ++k)
    if ((count >> k & 1) != 0) end = count % (1 << k) == 0 ? blocks[k] : blocks[k] + end * powers[k];
  return end;
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
  static constexpr int largest_fixed_degree = 16;  ///< at 16, the code for every degree takes a sixth longer

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    const int n = curve.degree();
    const auto coefficient = [](const auto& read) {
      if constexpr (Dimension == 1) {
        return read(0);
      } else {
        detail::OnAxes<Scalar, Dimension> axes;
        for (int axis = 0; axis < Dimension; ++axis) axes.values[static_cast<std::size_t>(axis)] = read(axis);
        return axes;
      }
    };
    const auto q = [&](int i) { return coefficient([&](int axis) { return curve(axis, i); }); };
    const auto from_end = [&](int k) { return coefficient([&](int axis) { return curve.from_end(axis, k); }); };
    const auto joined = [&] {
      if constexpr (Degree >= 0) {
        constexpr int most = std::bit_width(static_cast<unsigned>(Degree)) + 1;
        Scalar powers[most];
        powers[0] = t;
        for (int k = 1; 1 << k <= Degree; ++k) powers[k] = powers[k - 1] * powers[k - 1];
        return detail::joined<Degree + 1, Scalar>(q, powers);
      } else {
        return detail::joined(n + 1, q, from_end, t);
      }
    }();
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
