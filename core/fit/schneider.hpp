// SPDX-License-Identifier: MIT
// Formula: with the directions T_1, T_2 at the ends taken from the data, C(t_i) ~ P_i is linear in the lengths of the
//   two handles, b_1 = b_0 + alpha_1 T_1 and b_2 = b_3 + alpha_2 T_2. Least squares gives them by a 2x2 system, then
//   each t_i takes one Newton step towards the foot point of P_i, and both are repeated.
// Source: parameters by chord length, the system of the section "Fitting the curve", t_i - f/f' of
//   "Reparameterization", centre tangent at a split. As published, steps are only taken where the largest error is
//   below twice the tolerance (four times for squared errors). Errors are in coordinate units here, so that the scale
//   of the data does not matter. Alphas that are not above 2^-20 times the length, or above three times it, are
//   replaced by a third of it; the former, with the chord for the length and 1e-6, is the published heuristic of Wu and
//   Barsky.
// Cost: at most 20 steps, for m points.
// Bound: none of the fit itself; piecewise.hpp bounds the distance of every data point from the result.
// Fails: T_1 and T_2 are chords of the data. So samples of a cubic do not give it back, however small the tolerance:
//   the error at the ends is that of the chords. Reparametrisation converges linearly.
#pragma once

#include "core/fit/fitting.hpp"

namespace bezierbench {

struct Schneider {
  static constexpr MethodInfo info{.id = "schneider",
                                   .label = "Schneider",
                                   .problem = Problem::fitting,
                                   .form = Form::bernstein,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .promise = fit_promise,
                                   .flops = "O(d m) per step",
                                   .citation = "[Schneider 1990]"};

  template <int Dimension>
  static Piece<Dimension> piece(const Section<Dimension>& section) {
    constexpr int max_steps = 20;
    Piece<Dimension> piece{{}, section.t, 0};
    while (true) {
      piece.cubic = with_handles(section, piece.t);
      ++piece.iterations;
      const double error = largest_error(section, piece);
      if (error <= section.tolerance || error > 2 * section.tolerance || piece.iterations > max_steps) return piece;
      reparametrise(section, piece);
    }
  }

  /// The tangent by the chord between the two neighbours.
  template <int Dimension>
  static Point<double, Dimension> tangent(const Point<double, Dimension>& before,
                                          const Point<double, Dimension>& after) {
    return before + after;
  }

 private:
  template <int Dimension>
  static Cubic<Dimension> with_handles(const Section<Dimension>& section, const std::vector<double>& t) {
    const Point<double, Dimension> first = section.points.col(0);
    const Point<double, Dimension> last = section.points.col(section.points.cols() - 1);
    double c11 = 0;
    double c12 = 0;
    double c22 = 0;
    double x1 = 0;
    double x2 = 0;
    const double between = dot<Dimension>(section.start.direction, section.end.direction);
    for (std::size_t i = 0; i < t.size(); ++i) {
      const auto basis = cubic_basis(t[i]);
      const Point<double, Dimension> from_first = section.points.col(static_cast<Eigen::Index>(i)) - first;
      const Point<double, Dimension> rest = from_first - (basis[2] + basis[3]) * (last - first);
      c11 += basis[1] * basis[1];
      c12 += basis[1] * basis[2] * between;
      c22 += basis[2] * basis[2];
      x1 += basis[1] * dot<Dimension>(section.start.direction, rest);
      x2 += basis[2] * dot<Dimension>(section.end.direction, rest);
    }
    const double determinant = c11 * c22 - c12 * c12;
    double alpha1 = (x1 * c22 - x2 * c12) / determinant;
    double alpha2 = (c11 * x2 - c12 * x1) / determinant;
    const double least = 0x1p-20 * section.length;
    const double most = longest_handle * section.length;
    if (!(alpha1 > least && alpha2 > least && alpha1 < most && alpha2 < most)) alpha1 = alpha2 = section.length / 3;
    return {first, first + alpha1 * section.start.direction, last + alpha2 * section.end.direction, last};
  }

  template <int Dimension>
  static void reparametrise(const Section<Dimension>& section, Piece<Dimension>& piece) {
    for (std::size_t i = 0; i < piece.t.size(); ++i) {
      double& t = piece.t[i];
      const Slope<Dimension> f(offset_at<Dimension>(piece.cubic, section.points.col(static_cast<Eigen::Index>(i)), t));
      if (const double next = t - f.value / f.derivative; std::isfinite(next)) t = std::clamp(next, 0.0, 1.0);
    }
  }
};

}  // namespace bezierbench
