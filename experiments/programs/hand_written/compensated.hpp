// SPDX-License-Identifier: MIT
// Methods that carry the rounding errors of their operations along.
#pragma once

#include "core/evaluate/compensated_de_casteljau.hpp"
#include "core/evaluate/compensated_horner.hpp"
#include "core/evaluate/compensated_volk_schumaker.hpp"
#include "core/evaluate/horner_dd.hpp"
#include "experiments/programs/hand_written/by_hand.hpp"
#include "experiments/programs/hand_written/point.hpp"

namespace hand_written {

template <>
struct ByHand<bezierbench::CompensatedDeCasteljau> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    using P = Point<S, D>;
    const auto rest = exact_sum<S>(1, -t);
    const P s = on_every_axis<P>(rest.value);
    const P s_error = on_every_axis<P>(rest.error);
    const P right = on_every_axis<P>(t);
    std::array<P, N + 1> b;
    std::array<P, N + 1> error;
    for (std::size_t i = 0; i <= N; ++i) {
      b[i] = points[static_cast<int>(i)];
      error[i] = P{};
    }
    for (std::size_t last = N; last > 0; --last)
      for (std::size_t i = 0; i < last; ++i) {
        const auto of_left = exact_product<P>(s, b[i]);
        const auto of_right = exact_product<P>(right, b[i + 1]);
        const auto sum = exact_sum<P>(of_left.value, of_right.value);
        const P local = ((of_left.error + of_right.error) + sum.error) + s_error * b[i];
        error[i] = (local + right * error[i + 1]) + s * error[i];
        b[i] = sum.value;
      }
    const auto sum = exact_sum<P>(b[0], error[0]);
    return sum.value + sum.error;
  }
};

template <>
struct ByHand<bezierbench::CompensatedHorner> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    using P = Point<S, D>;
    const P on_axes = on_every_axis<P>(t);
    P p = q[N];
    P error{};
    for (int j = N - 1; j >= 0; --j) {
      const auto product = exact_product<P>(p, on_axes);
      const auto sum = exact_sum<P>(product.value, q[j]);
      p = sum.value;
      error = error * on_axes + (product.error + sum.error);
    }
    return p + error;
  }
};

template <>
struct ByHand<bezierbench::HornerDoubleDouble> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& high, const Points<S, D, N>& low) {
    using P = Point<S, D>;
    const P on_axes = on_every_axis<P>(t);
    P p = high[N];
    P error = low[N];
    for (int j = N - 1; j >= 0; --j) {
      const auto product = exact_product<P>(p, on_axes);
      const auto sum = exact_sum<P>(product.value, high[j]);
      p = sum.value;
      error = error * on_axes + ((product.error + sum.error) + low[j]);
    }
    return p + error;
  }
};

template <>
struct ByHand<bezierbench::CompensatedVolkSchumaker> {
  template <class P>
  static Exact<P> product_of(const Exact<P>& a, const Exact<P>& b) {
    const auto product = exact_product<P>(a.value, b.value);
    return {product.value, product.error + (a.value * b.error + a.error * b.value)};
  }

  template <class S>
  static Exact<S> power_of(Exact<S> base, int exponent) {
    Exact<S> result{1, 0};
    for (; exponent > 1; exponent /= 2) {
      if (exponent % 2 != 0) result = product_of(result, base);
      base = product_of(base, base);
    }
    return product_of(result, base);
  }

  /// `c` are the points times binomials, `lost` are their rounding errors.
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& c, const Points<S, D, N>& lost) {
    using P = Point<S, D>;
    const auto s = exact_sum<S>(1, -t);
    const bool near_start = t + t <= 1;
    const Exact<S> larger = near_start ? s : Exact<S>{t, 0};
    const Exact<S> smaller = near_start ? Exact<S>{t, 0} : s;
    const S quotient = smaller.value / larger.value;
    const S remainder = fused<S>(-quotient, larger.value, smaller.value);
    const S r_error = (remainder + (smaller.error - quotient * larger.error)) / larger.value;
    const P r = on_every_axis<P>(quotient);
    P p = c[near_start ? N : 0];
    P error = lost[near_start ? N : 0];
    for (int i = 1; i <= N; ++i) {
      const int k = near_start ? N - i : i;
      const auto product = exact_product<P>(p, r);
      const auto sum = exact_sum<P>(product.value, c[k]);
      error = error * r + (p * r_error + ((product.error + sum.error) + lost[k]));
      p = sum.value;
    }
    const auto scale = power_of<S>(larger, N);
    const auto result = product_of<P>({p, error}, {on_every_axis<P>(scale.value), on_every_axis<P>(scale.error)});
    return result.value + result.error;
  }
};

}  // namespace hand_written
