// SPDX-License-Identifier: MIT
// Formula: Simpson's 3/8 rule S = (b-a)/8 (f_0 + 3 f_1 + 3 f_2 + f_3) on a panel and on its halves, extrapolated:
//   S_left + S_right + (S_left + S_right - S)/15; a panel is halved until that is proved to be good enough. The factor
//   15: the error falls by 16 when a panel of a smooth integrand is halved.
// Cost: per panel bounds from the control vectors, and 7 speeds. Hodographs are halved by de Casteljau's algorithm.
// Bound: proved. S misses at most F/6480 of the mean of a speed whose fourth derivative is at most F, over a panel of
//   width 1 ([Davis and Rabinowitz 1984], section 2.2), so the halves F/103680, and what is extrapolated 16/15 F/103680
//   + F/97200 = F/48600. F is that of `fourth_derivative`. Where it proves nothing, as at a cusp or a turn, the
//   length lies between those of the chord and of the control polygon. The difference of two sums proves nothing:
//   neither sum changes by a turn between two abscissae.
// Fails: slow below about 1e-12; a tolerance near u is refused in the end, for the roundings are part of the estimate.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/speed.hpp"
#include "core/arc_length/squared_speeds.hpp"
#include "core/curve.hpp"

namespace bezierbench {

// A bound of the fourth derivative of the speed f = |h| over a panel, from the control vectors of h.
//
// Derived in docs/proofs/fourth_derivative.md, from bounds of the derivatives of h and a lower bound of |h|.

/// A bound of |f''''| on [0, 1] for the speed f; infinite where no positive lower bound of |h| is known.
struct FourthDerivative {
  double bound = std::numeric_limits<double>::infinity();
  /// The part of the bound that comes from roundings, which remains when panels are halved.
  double rounding = 0;
};

namespace detail {

/// A lower bound of |h| on [0, 1], trivial where it is 0 or less.
template <int Dimension, int Degree>
double min_size(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  std::array<double, Dimension> mean{};
  for (int i = 0; i <= h.degree(); ++i)
    for (std::size_t axis = 0; axis < Dimension; ++axis) mean[axis] += h(static_cast<int>(axis), i);
  double square = 0;
  for (const double x : mean) square += x * x;
  if (square == 0) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= h.degree(); ++i) {
    double along = 0;
    for (std::size_t axis = 0; axis < Dimension; ++axis) along += h(static_cast<int>(axis), i) * mean[axis];
    least = std::min(least, along);
  }
  return least / std::sqrt(square);
}

}  // namespace detail

/// Bounds of a function and of its first four derivatives on [0, 1].
using DerivativeSizes = std::array<double, 5>;

/// The largest sizes of h and its derivatives; the part of the last of them that comes from roundings is `rounding`.
template <int Dimension, int Degree>
DerivativeSizes derivative_sizes(const Curve<Form::bernstein, double, Dimension, Degree>& h, double& rounding) {
  constexpr double u = 0x1p-53;
  const int m = h.degree();
  const double longest = longest_vector(h);
  DerivativeSizes sizes{longest};
  double factor = 1;
  auto differences = h;
  for (int k = 1; k <= std::min(m, 4); ++k) {
    for (int i = 0; i <= m - k; ++i)
      for (int axis = 0; axis < Dimension; ++axis)
        differences(axis, i) = differences(axis, i + 1) - differences(axis, i);
    factor *= m - k + 1;
    rounding = factor * k * std::ldexp(u, k) * Dimension * longest;
    sizes[static_cast<std::size_t>(k)] = factor * longest_vector(differences, m - k) + rounding;
  }
  return sizes;
}

/// Those of |h|; infinite where no positive lower bound of |h| is known.
template <int Dimension, int Degree>
DerivativeSizes speed_derivatives(const Curve<Form::bernstein, double, Dimension, Degree>& h, double& rounding) {
  constexpr double u = 0x1p-53;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto sizes = derivative_sizes(h, rounding);
  const auto [longest, v, a, j, s] = sizes;
  const double least = detail::min_size(h) - 4 * Dimension * u * longest;
  if (!(least > 0)) return {longest, infinity, infinity, infinity, infinity};
  const double second = v * v / least + a;
  const double third = 3 * v * (a + second) / least + j;
  return {longest, v, second, third, (4 * v * (j + third) + 3 * second * second) / least + s};
}

template <int Dimension, int Degree>
FourthDerivative fourth_derivative(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  FourthDerivative result;
  result.bound = speed_derivatives(h, result.rounding)[4];
  return result;
}

struct AdaptiveSimpson38 {
  static constexpr int depth_limit = 40;

  static constexpr MethodInfo info{.id = "adaptive_simpson38",
                                   .label = "Adaptive Simpson 3/8",
                                   .problem = Problem::arc_length,
                                   .form = Form::bernstein,
                                   .promise = "proved: the tolerance, or converged is no",
                                   .flops = "per speed 3d n(n-1)/2 + 2d",
                                   .cost_exponent = 2,
                                   .citation = "[Document 000], eq. (13); [Davis and Rabinowitz 1984]"};

  template <class Hodograph>
  static ArcLength measure(const Hodograph& hodograph, double tolerance) {
    return with_fixed_degree(hodograph, [tolerance](const auto& h) { return measure_copy(h, tolerance); });
  }

 private:
  template <class Hodograph>
  struct Search;

  template <class Hodograph>
  static ArcLength measure_copy(Hodograph hodograph, double tolerance) {
    Search<Hodograph> search;
    // A first length makes the tolerance absolute. Half of it is taken, since it may exceed the true length.
    const double first_length = search.first_length(hodograph);
    search.allowed = tolerance * first_length / 2;
    search.rounding = rounding_of_length(hodograph, 6 * hodograph.degree() + 3 * depth_limit + 32);
    ArcLength& result = search.result;
    result.error_estimate = search.rounding;
    search.add_panel(hodograph, 1, 0);
    result.converged = result.error_estimate <= tolerance * result.length;
    return result;
  }

  template <class Hodograph>
  struct Search {
    decltype(speeds_for(std::declval<const Hodograph&>())) speeds;
    double allowed = 0;   ///< absolute error allowed in the mean speed of a panel
    double rounding = 0;  ///< absolute rounding error of the length
    ArcLength result{.length = 0, .error_estimate = 0};

    /// A first length: the mean of the speeds in the middles of many equal parts.
    double first_length(const Hodograph& h) {
      constexpr std::size_t count = decltype(speeds)::count;
      const int groups = h.degree() / 2 + 1;
      const double parts = static_cast<double>(count) * groups;
      double sum = 0;
      for (int group = 0; group < groups; ++group) {
        std::array<double, count> t;
        for (std::size_t k = 0; k < count; ++k)
          t[k] = (static_cast<double>(count) * group + static_cast<double>(k) + 0.5) / parts;
        for (const double f : speeds.speeds(h, t)) sum += f;
      }
      result.evaluations += static_cast<std::int64_t>(parts);
      return sum / parts;
    }

    /// The mean speed of a panel, extrapolated from S of both halves and of the whole.
    double mean_speed(const Hodograph& h) {
      static constexpr std::array<double, 8> abscissae{0, 1.0 / 6, 1.0 / 3, 0.5, 2.0 / 3, 5.0 / 6, 1, 1};
      const auto f = speeds.speeds(h, abscissae);
      result.evaluations += 7;
      const double halves = ((f[0] + f[6]) + 3 * ((f[1] + f[5]) + (f[2] + f[4])) + 2 * f[3]) / 16;
      const double whole = ((f[0] + f[6]) + 3 * (f[2] + f[4])) / 8;
      return halves + (halves - whole) / 15;
    }

    /// Adds the length of a panel, `width` wide in the parameter. Overwrites its hodograph h.
    void add_panel(Hodograph& h, double width, int depth) {
      const auto fourth = fourth_derivative(h);
      const double missed = fourth.bound / 48600;
      const double longest = polygon_length(h);
      const double shortest = std::min(chord_length(h), longest);
      const double enough = std::max(allowed, rounding);
      const bool proved = missed <= std::max(enough, fourth.rounding / 16200);
      if (proved || longest - shortest <= enough || depth == depth_limit) {
        const double speed = std::clamp(mean_speed(h), shortest, longest);
        result.length += width * speed;
        result.error_estimate += width * std::min(missed, std::max(longest - speed, speed - shortest));
        return;
      }
      auto left = cut_left_half(h);
      add_panel(left, width / 2, depth + 1);
      add_panel(h, width / 2, depth + 1);
    }
  };
};

}  // namespace bezierbench
