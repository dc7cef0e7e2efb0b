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
// Fails: the constants are not proved. Tested for degrees up to 20.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/gauss_legendre.hpp"
#include "core/arc_length/speed.hpp"

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
    // The tolerance made absolute by a first length, of which half is taken, for that length may be too large.
    ArcLength first;
    const double first_length = integral<24>(hodograph, first);
    auto result = measure_within(hodograph, tolerance * first_length / 2);
    result.evaluations += first.evaluations;
    result.converged = result.error_estimate <= tolerance * result.length;
    return result;
  }

  /// The same for an absolute tolerance of the integral over [0, 1]; `converged` where the estimate is at most that.
  template <int Dimension>
  static ArcLength measure_within(const Curve<Form::bernstein, double, Dimension>& hodograph, double absolute) {
    ArcLength result;
    result.error_estimate = rounding_of_length(hodograph, 6 * hodograph.degree() + 3 * depth_limit + 32);
    add_panel(Panel<Dimension>{hodograph, 1, absolute, 0}, result);
    result.converged = result.error_estimate <= absolute;
    return result;
  }

 private:
  template <int Dimension>
  struct Panel {
    Curve<Form::bernstein, double, Dimension> hodograph;
    double width;  ///< of the parameter
    double share;  ///< of the absolute tolerance
    int depth;
  };
  struct Local {
    double speed;  ///< |h|
    double slope;  ///< |h'|
  };

  /// Level m-1 of de Casteljau's triangle holds two points: h lies between them, h' is m times their difference.
  template <int Dimension>
  static Local at(Curve<Form::bernstein, double, Dimension> h, double t) {
    const int m = h.degree();
    const double s = 1 - t;
    for (int level = 1; level < m; ++level)
      for (int i = 0; i <= m - level; ++i)
        for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = s * h(axis, i) + t * h(axis, i + 1);
    double square = 0;
    double slope_square = 0;
    for (int axis = 0; axis < Dimension; ++axis) {
      const double value = m == 0 ? h(axis, 0) : s * h(axis, 0) + t * h(axis, 1);
      const double slope = m == 0 ? 0 : m * (h(axis, 1) - h(axis, 0));
      square += value * value;
      slope_square += slope * slope;
    }
    return {std::sqrt(square), std::sqrt(slope_square)};
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

  template <int Points, int Dimension>
  static double integral(const Curve<Form::bernstein, double, Dimension>& h, ArcLength& result) {
    result.evaluations += Points;
    return gauss_integral<Points>([&](double t) { return at(h, t).speed; });
  }

  template <int Dimension>
  static void add_panel(const Panel<Dimension>& panel, ArcLength& result) {
    const auto& h = panel.hodograph;
    double eight = 0;
    double ratio = 0;  // integral of |h'|^2 / |h|^2 over [0, 1], which is 2 e
    for_each_gauss_node<8>([&](double t, double weight) {
      const Local local = at(h, t);
      eight += weight * local.speed;
      if (local.slope != 0) ratio += weight * (local.slope / local.speed) * (local.slope / local.speed);
    });
    result.evaluations += 8;
    const double slack = panel.width * std::max(polygon_length(h) - chord(h), 0.0);
    const double e = ratio / 2;
    const double cube = e * e * e;
    const double error_8 = safety * std::min(2.5e-6 * cube, 3e-2) * slack;
    const double error_16 = safety * std::min(1.5e-11 * cube * cube, 9e-3) * slack;
    const double error_24 = safety * std::min(3.5e-16 * cube * cube * cube, 3.5e-3) * slack;
    const auto take = [&](double length, double error) {
      result.length += panel.width * length;
      result.error_estimate += error;
    };
    if (error_8 <= panel.share) return take(eight, error_8);
    if (error_16 <= panel.share) return take(integral<16>(h, result), error_16);
    if (error_24 <= panel.share) return take(integral<24>(h, result), error_24);
    if (panel.depth == depth_limit) return take(eight, slack);
    for (const bool left : {true, false})
      add_panel(Panel<Dimension>{half(h, left), panel.width / 2, panel.share / 2, panel.depth + 1}, result);
  }

  /// The left or right half of a curve.
  template <int Dimension>
  static Curve<Form::bernstein, double, Dimension> half(Curve<Form::bernstein, double, Dimension> h, bool left) {
    const int m = h.degree();
    auto result = h;
    for (int level = 0; level <= m; ++level) {
      for (int axis = 0; axis < Dimension; ++axis)
        if (left)
          result(axis, level) = h(axis, 0);
        else
          result(axis, m - level) = h(axis, m - level);
      for (int i = 0; i < m - level; ++i)
        for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = (h(axis, i) + h(axis, i + 1)) / 2;
    }
    return result;
  }
};

}  // namespace bezierbench
