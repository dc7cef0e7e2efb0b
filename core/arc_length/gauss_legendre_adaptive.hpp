// SPDX-License-Identifier: MIT
// Formula: on each panel the Gauss-Legendre rule with the fewest of 8, 16 and 24 points that is proved to keep the
//   tolerance; where none is, the panel is halved.
// Source: [Levien 2018], which chooses among rules by an error that was fitted to experiments with cubics;
//   [Trefethen 2013], theorem 19.3, by which the errors here are proved, for any degree (`proved_rule`). De
//   Casteljau's algorithm halves hodographs. Where no rule is proved on a panel, as at a cusp, its length lies between
//   those of the chord and of the control polygon; where these are near enough, their mean is taken.
// Cost: per panel a Chebyshev series of the hodograph, and 8, 16 or 24 speeds.
// Bound: proved: the sum of the bounds of all panels, and of roundings.
// Fails: a tolerance near u is not met in the end, for the roundings are part of the bound.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/chebyshev_series.hpp"
#include "core/arc_length/gauss_legendre.hpp"
#include "core/arc_length/speed.hpp"
#include "core/arc_length/squared_speeds.hpp"
#include "core/powers.hpp"
#include "core/vector/vectors.hpp"

namespace bezierbench {

// The Gauss-Legendre rule with the fewest points that the Chebyshev series of h proves to miss no more than is allowed
// of the mean speed |h| on [-1, 1].
//
// Theory: the error of N points for a function that is analytic in an ellipse ([Trefethen 2013], theorem 19.3);
//   docs/proofs/proved_rule.md shows that |h| is, where the first coefficient exceeds the others there.
// Cost: one ellipse per rule, just large enough for the error that is allowed.
// Bound: the constants are rounded up by a few u, which cover the roundings of the bound itself.

/// A rule of 8, 16 or 24 points; 0 points if none is proved.
struct ProvedRule {
  int points = 0;
  double missed = 0;  ///< largest error of the mean speed
};

namespace detail {

inline constexpr std::size_t gauss_rules = 3;
inline constexpr std::size_t ellipse_count = 64;

/// Ellipses with rho = 2^(1/16), 2^(2/16) ... 16.
struct Ellipses {
  std::array<double, ellipse_count> half_axis;                        ///< (rho + 1/rho)/2 = A_1
  std::array<std::array<double, ellipse_count>, gauss_rules> missed;  ///< largest error of each rule, for M = 1
};

inline constexpr Ellipses ellipses = [] {
  Ellipses table{};
  double rho = 1;
  for (std::size_t i = 0; i < ellipse_count; ++i) {
    rho *= 1.0442737824274138;
    table.half_axis[i] = (rho + 1 / rho) / 2;
    const double by_eight_points = integer_power(1 / rho, 16);
    double missed = 32.0 / 15 * (1 + 0x1p-20) / (1 - 1 / (rho * rho));
    for (auto& row : table.missed) row[i] = missed *= by_eight_points;
  }
  return table;
}();

/// The index of the smallest ellipse with which the rule of 8 `eights` points misses at most 2^-exponent M: rho^(-16
/// eights) <= 2^-(exponent + 3). The factor before rho^(-2N) in the theorem is at most 8 from rho = 1.2 on.
constexpr std::size_t ellipse_for(int exponent, int eights) {
  return static_cast<std::size_t>(std::max((exponent + 2) / eights, 0));
}

}  // namespace detail

/// The rule that is proved for the mean speed on [-1, 1]. `allowed` is absolute; the part cut from the series, `cut`,
/// counts twice. With `weight`, the denominator is also proved to stay above half of its first coefficient.
template <int Dimension>
ProvedRule proved_rule(const ChebyshevSeries<Dimension>& h, double cut, double allowed,
                       const ChebyshevSeries<1>* weight = nullptr) {
  using detail::ellipses;
  using Lanes = VectorOf<double, 4>;  // one for each rule, and one that is not used
  const double allowed_of_rule = allowed - 2 * cut;
  const double limit = h.size(0) * (1 - 0x1p-20);
  const double largest = 2 * h.size(0);
  if (!(allowed_of_rule > 0 && limit > 0)) return {};
  if (h.degree() == 0 && weight == nullptr) return {8, 2 * cut};  // a constant, of which a rule misses nothing
  const int exponent = binary_exponent(largest / allowed_of_rule);
  const auto last = detail::ellipse_count - 1;
  const std::array<std::size_t, detail::gauss_rules> ellipse{std::min(detail::ellipse_for(exponent, 1), last),
                                                             std::min(detail::ellipse_for(exponent, 2), last),
                                                             std::min(detail::ellipse_for(exponent, 3), last)};
  const Lanes half_axis{ellipses.half_axis[ellipse[0]], ellipses.half_axis[ellipse[1]], ellipses.half_axis[ellipse[2]]};
  const Lanes twice = 2 * half_axis;
  const auto sum_of = [&](const auto& series) {  // all but the first, each at its largest in the ellipses
    Lanes before{1, 1, 1};
    Lanes here = half_axis;
    Lanes sum{};
    for (std::size_t k = 1; k <= series.degree(); ++k) {
      sum += series.size(k) * here;
      const Lanes after = twice * here - before;  // A_(k+1) = T_(k+1)(A_1)
      before = here;
      here = after;
    }
    return sum;
  };
  const Lanes sum = sum_of(h);
  Lanes sum_of_weight{};
  double limit_of_weight = 0;
  if (weight != nullptr) {
    sum_of_weight = sum_of(*weight);
    limit_of_weight = weight->size(0) * (0.5 - 0x1p-20) - weight->cut();
  }
  for (std::size_t r = 0; r < detail::gauss_rules; ++r) {
    const double missed = largest * ellipses.missed[r][ellipse[r]];
    if (sum[r] <= limit && sum_of_weight[r] <= limit_of_weight && missed <= allowed_of_rule)
      return {8 * static_cast<int>(r + 1), missed + 2 * cut};
  }
  return {};
}

template <int Dimension>
ProvedRule proved_rule(const ChebyshevSeries<Dimension>& h, double allowed) {
  return proved_rule(h, h.cut(), allowed);
}

template <int Dimension, int Degree>
ChebyshevSeries<Dimension> series_for(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  return ChebyshevSeries<Dimension>(h.degree());
}

/// Replaces the series by that of h; returns the part of cut() that comes from rounding.
template <int Dimension, int Degree>
double expand(ChebyshevSeries<Dimension>& series, const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  const double size = longest_vector(h);
  series.expand(h, size);
  return series.rounding(size);
}

/// Whether a rule may be proved for h; none is where the ends of h are a right angle or more apart. h(1) + h(-1) is
/// twice the sum of the even terms of the series of h, and h(1) - h(-1) twice that of the odd ones. A proof needs
/// that the sizes of all terms after a_0 sum to less than |a_0|, so that the first sum is the longer one.
template <int Dimension, int Degree>
bool may_be_proved(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  double product = 0;
  for (int axis = 0; axis < Dimension; ++axis) product += h(axis, 0) * h(axis, h.degree());
  return product > 0;
}

struct GaussLegendreAdaptive {
  static constexpr int depth_limit = 40;

  static constexpr MethodInfo info{.id = "gauss_legendre_adaptive",
                                   .label = "Adaptive Gauss-Legendre, 8 to 24 points",
                                   .problem = Problem::arc_length,
                                   .form = Form::bernstein,
                                   .promise = "proved: the tolerance, or converged is no",
                                   .flops = "per speed 3d n(n-1)/2 + 2d",
                                   .cost_exponent = 2,
                                   .citation = "[Levien 2018]; [Trefethen 2013], theorem 19.3"};

  template <class Hodograph>
  static ArcLength measure(const Hodograph& hodograph, double tolerance) {
    return with_fixed_degree(hodograph, [tolerance](const auto& h) {
      Search search(h);
      // A first length makes the tolerance absolute. Half of it is taken, since it may exceed the true length.
      const double first_length = search.template integral<8>(h);
      auto result = within(h, tolerance * first_length / 2, search);
      result.converged = result.error_estimate <= tolerance * result.length;
      return result;
    });
  }

  /// The same for an absolute tolerance of the integral over [0, 1]; `converged` if the error estimate is at most that.
  template <class Hodograph>
  static ArcLength measure_within(const Hodograph& hodograph, double absolute) {
    return with_fixed_degree(hodograph, [absolute](const auto& h) {
      Search search(h);
      return within(h, absolute, search);
    });
  }

 private:
  template <class Hodograph>
  struct Search;

  template <class Hodograph>
  static ArcLength within(Hodograph hodograph, double absolute, Search<Hodograph>& search) {
    ArcLength& result = search.result;
    search.allowed = absolute;
    result.error_estimate = rounding_of_length(hodograph, 6 * hodograph.degree() + 3 * depth_limit + 32);
    search.add_panel(hodograph, 1, 0);
    result.converged = result.error_estimate <= absolute;
    return result;
  }

  /// One measurement: the result so far, and working memory.
  template <class Hodograph>
  struct Search {
    explicit Search(const Hodograph& h) : series(series_for(h)) {}

    decltype(speeds_for(std::declval<const Hodograph&>())) speeds;
    decltype(series_for(std::declval<const Hodograph&>())) series;
    double allowed = 0;  ///< absolute error allowed in the mean speed of a panel
    ArcLength result{.length = 0, .error_estimate = 0};

    /// The mean speed of a panel by one rule.
    template <int Points>
    double integral(const Hodograph& h) {
      constexpr const auto& rule = unit_rule<Points>;
      constexpr std::size_t count = decltype(speeds)::count;
      static_assert(Points % count == 0);
      double sum = 0;
      for (std::size_t first = 0; first < Points; first += count) {
        const auto values = speeds.speeds(h, std::span(rule.t).subspan(first).template first<count>());
        for (std::size_t k = 0; k < count; ++k) sum += rule.weight[first + k] * values[k];
      }
      result.evaluations += Points;
      return sum;
    }

    /// Adds the length of a panel, `width` wide in the parameter. Overwrites its hodograph h.
    void add_panel(Hodograph& h, double width, int depth) {
      const auto take = [&](double mean_speed, double error) {
        result.length += width * mean_speed;
        result.error_estimate += width * error;
      };
      if (may_be_proved(h)) {
        const double attainable = std::max(allowed, 4 * expand(series, h));
        series.shorten(attainable / 16);
        const auto rule = proved_rule(series, attainable);
        if (rule.points == 8) return take(integral<8>(h), rule.missed);
        if (rule.points == 16) return take(integral<16>(h), rule.missed);
        if (rule.points == 24) return take(integral<24>(h), rule.missed);
      }
      const double longest = polygon_length(h);
      const double shortest = std::min(chord_length(h), longest);
      const double half_difference = (longest - shortest) / 2;
      if (half_difference <= allowed || depth == depth_limit) return take(shortest + half_difference, half_difference);
      auto left = cut_left_half(h);
      add_panel(left, width / 2, depth + 1);
      add_panel(h, width / 2, depth + 1);
    }
  };
};

}  // namespace bezierbench
