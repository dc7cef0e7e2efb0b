// SPDX-License-Identifier: MIT
// On each panel e = integral of |C''|^2 / |C'|^2 over [-1, 1] by 8 points, the curve taken over [-1, 1], foretells the
// errors of the rules with 8, 16 and 24 points; the first that is good enough is taken, or the panel is halved.
//
// Source: the arc length of a cubic in kurbo (Levien), whose constants these are, found there by experiment. With P the
//   length of the panel's control polygon and C that of its chord, between which the length lies, the errors are
//      8 points   min(2.5e-6 e^3, 3e-2) (P - C)
//     16 points   min(1.5e-11 e^6, 9e-3) (P - C)
//     24 points   min(3.5e-16 e^9, 3.5e-3) (P - C)
//   Here for any degree, on hodographs halved by de Casteljau's algorithm, and sixteen times these: as they are, one
//   promise in 800,000 on random curves of degree 2 to 4 was broken, by a factor of 2.2.
// Cost: per panel 8 speeds with derivatives, and 16 or 24 more where more points are taken.
// Estimate: the sum of the foretold errors, of P - C, which is proved, where the depth ends, and of the roundings.
// Fails: the constants are not proved. Tested for degrees up to 20. suites/arc_length.toml with --trials 460 breaks one
//   promise: degree 10, random, tolerance 1e-12, trial 371, by a factor of 3.6.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/gauss_legendre.hpp"
#include "core/arc_length/speed.hpp"
#include "core/arc_length/squared_speeds.hpp"

namespace bezierbench {

struct GaussLegendreAdaptive {
  static constexpr int depth_limit = 40;
  static constexpr double safety = 16;

  static constexpr MethodInfo info{.id = "gauss_legendre_adaptive",
                                   .label = "Adaptive Gauss-Legendre, 8 to 24 points",
                                   .problem = Problem::arc_length,
                                   .form = Form::bernstein,
                                   .promise = "the tolerance, or converged is no",
                                   .flops = "per speed 3d n(n-1)/2 + 3d + 2",
                                   .cost_exponent = 2,
                                   .citation = "Levien, kurbo, arc length of cubics"};

  template <int Dimension>
  static ArcLength measure(const Curve<Form::bernstein, double, Dimension>& hodograph, double tolerance) {
    Search<Dimension> search;
    // The tolerance made absolute by a first length, of which half is taken, for that length may be too large.
    const double first_length = search.template integral<24>(hodograph);
    auto result = within(hodograph, tolerance * first_length / 2, search);
    result.converged = result.error_estimate <= tolerance * result.length;
    return result;
  }

  /// The same for an absolute tolerance of the integral over [0, 1]; `converged` where the estimate is at most that.
  template <int Dimension>
  static ArcLength measure_within(const Curve<Form::bernstein, double, Dimension>& hodograph, double absolute) {
    Search<Dimension> search;
    return within(hodograph, absolute, search);
  }

 private:
  template <int Dimension>
  struct Search;

  template <int Dimension>
  static ArcLength within(const Curve<Form::bernstein, double, Dimension>& hodograph, double absolute,
                          Search<Dimension>& search) {
    ArcLength& result = search.result;
    result.error_estimate = rounding_of_length(hodograph, 6 * hodograph.degree() + 3 * depth_limit + 32);
    auto whole = hodograph;
    search.add_panel(whole, 1, absolute, 0);
    result.converged = result.error_estimate <= absolute;
    return result;
  }

  /// The length of the chord, |mean of the control vectors|.
  template <int Dimension>
  static double chord(const Curve<Form::bernstein, double, Dimension>& h) {
    double square = 0;
    for (int axis = 0; axis < Dimension; ++axis) {
      double sum = 0;
      for (int i = 0; i <= h.degree(); ++i) sum += h(axis, i);
      square += sum * sum;
    }
    return std::sqrt(square) / (h.degree() + 1);
  }

  /// Leaves the right half of a curve in h and returns the left one.
  template <int Dimension>
  static Curve<Form::bernstein, double, Dimension> cut_left_half(Curve<Form::bernstein, double, Dimension>& h) {
    const int m = h.degree();
    Curve<Form::bernstein, double, Dimension> left(m);
    for (int level = 0; level <= m; ++level) {
      for (int axis = 0; axis < Dimension; ++axis) left(axis, level) = h(axis, 0);
      for (int i = 0; i < m - level; ++i)
        for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = (h(axis, i) + h(axis, i + 1)) / 2;
    }
    return left;
  }

  /// One measurement: what its panels add up to, and where their speeds are worked out.
  template <int Dimension>
  struct Search {
    static constexpr std::size_t count = SquaredSpeeds<Dimension>::count;
    SquaredSpeeds<Dimension> squared_speeds;
    ArcLength result{.length = 0, .error_estimate = 0};

    /// The length of a panel by a rule that is good enough.
    template <int Points>
    double integral(const Curve<Form::bernstein, double, Dimension>& h) {
      constexpr const auto& rule = unit_rule<Points>;
      static_assert(Points % count == 0);
      double sum = 0;
      for (std::size_t first = 0; first < Points; first += count) {
        const auto squares = squared_speeds(h, std::span(rule.t).subspan(first).template first<count>());
        for (std::size_t k = 0; k < count; ++k) sum += rule.weight[first + k] * std::sqrt(squares.speed[k]);
      }
      result.evaluations += Points;
      return sum;
    }

    /// A panel of this width of the parameter, with its share of the absolute tolerance; spoils its hodograph h.
    void add_panel(Curve<Form::bernstein, double, Dimension>& h, double width, double share, int depth) {
      constexpr const auto& rule = unit_rule<8>;
      const auto squares = squared_speeds(h, rule.t);
      result.evaluations += count;
      std::array<double, count> ratios;
      for (std::size_t k = 0; k < count; ++k)
        ratios[k] = squares.slope[k] / (squares.slope[k] == 0 ? 1 : squares.speed[k]);
      double eight = 0;
      double ratio = 0;  // integral of |h'|^2 / |h|^2 over [0, 1], which is 2 e
      for (std::size_t k = 0; k < count; ++k) {
        eight += rule.weight[k] * std::sqrt(squares.speed[k]);
        ratio += rule.weight[k] * ratios[k];
      }
      const double slack = width * std::max(polygon_length(h) - chord(h), 0.0);
      const double e = ratio / 2;
      const double cube = e * e * e;
      const double error_8 = safety * std::min(2.5e-6 * cube, 3e-2) * slack;
      const double error_16 = safety * std::min(1.5e-11 * cube * cube, 9e-3) * slack;
      const double error_24 = safety * std::min(3.5e-16 * cube * cube * cube, 3.5e-3) * slack;
      const auto take = [&](double length, double error) {
        result.length += width * length;
        result.error_estimate += error;
      };
      if (error_8 <= share) return take(eight, error_8);
      if (error_16 <= share) return take(integral<16>(h), error_16);
      if (error_24 <= share) return take(integral<24>(h), error_24);
      if (depth == depth_limit) return take(eight, slack);
      auto left = cut_left_half(h);
      add_panel(left, width / 2, share / 2, depth + 1);
      add_panel(h, width / 2, share / 2, depth + 1);
    }
  };
};

}  // namespace bezierbench
