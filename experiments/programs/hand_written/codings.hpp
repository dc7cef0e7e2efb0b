// SPDX-License-Identifier: MIT
// Evaluators as one writes them by hand for one case: the plane, double precision, a degree known at compile time, the
// two coordinates side by side in one vector. Operations, their order and so their bits are those of the methods of the
// same names in core/evaluate; no code of core is in them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#ifdef __FMA__
#include <immintrin.h>
#endif

namespace hand_written {

/// A point of the plane.
using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;

/// t a + b, rounded once. GCC 12 makes no vector instruction of two calls of std::fma here.
inline Pair fused(double t, Pair a, Pair b) {
#ifdef __FMA__
  return _mm_fmadd_pd(_mm_set1_pd(t), a, b);
#else
  return Pair{std::fma(t, a[0], b[0]), std::fma(t, a[1], b[1])};
#endif
}

template <int Degree>
using Points = std::array<Pair, Degree + 1>;

/// Curves as they are given: nothing to prepare.
template <int Degree>
struct AsGiven {
  static void prepare(Points<Degree>& /*points*/) {}
};

template <int Degree>
struct DeCasteljau : AsGiven<Degree> {
  static constexpr const char* id = "de_casteljau";
  static Pair evaluate(Points<Degree> b, double t) {
    const double s = 1 - t;
    for (std::size_t last = Degree; last > 0; --last)
      for (std::size_t i = 0; i < last; ++i) b[i] = s * b[i] + t * b[i + 1];
    return b[0];
  }
};

template <int Degree>
struct DeCasteljauLerpFma : AsGiven<Degree> {
  static constexpr const char* id = "de_casteljau_lerp_fma";
  static Pair evaluate(Points<Degree> b, double t) {
    for (std::size_t last = Degree; last > 0; --last)
      for (std::size_t i = 0; i < last; ++i) b[i] = fused(t, b[i + 1] - b[i], b[i]);
    return b[0];
  }
};

template <int Degree>
struct WoznyChudy : AsGiven<Degree> {
  static constexpr const char* id = "wozny_chudy";
  static Pair evaluate(const Points<Degree>& b, double t) {
    const double s = 1 - t;
    const bool near_start = t + t <= 1;
    const double ratio = near_start ? t / s : s / t;
    const double of_h = near_start ? ratio : 1;
    const double of_k = near_start ? 1 : ratio;
    Pair q = b[0];
    double h = 1;
    for (std::size_t k = 1; k <= Degree; ++k) {
      const double numerator = h * of_h * static_cast<double>(Degree - k + 1);
      h = numerator / (static_cast<double>(k) * of_k + numerator);
      q = (1 - h) * q + h * b[k];
    }
    return q;
  }
};

template <int Degree>
struct HornerBernstein {
  static constexpr const char* id = "horner_bernstein";
  static void prepare(Points<Degree>& b) {
    double binomial = 1;  // exact: at most C(20,10)
    for (std::size_t i = 0; i <= Degree; ++i) {
      b[i] = b[i] * binomial;
      binomial = binomial * static_cast<double>(Degree - i) / static_cast<double>(i + 1);
    }
  }
  static Pair evaluate(const Points<Degree>& c, double t) {
    const double s = 1 - t;
    Pair p = c[0];
    double power = 1;
    for (std::size_t i = 1; i <= Degree; ++i) {
      power *= t;
      p = p * s + c[i] * power;
    }
    return p;
  }
};

template <int Degree>
struct Horner : AsGiven<Degree> {
  static constexpr const char* id = "horner";
  static Pair evaluate(const Points<Degree>& q, double t) {
    Pair p = q[Degree];
    for (std::size_t i = Degree; i-- > 0;) p = p * t + q[i];
    return p;
  }
};

}  // namespace hand_written
