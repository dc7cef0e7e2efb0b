// SPDX-License-Identifier: MIT
// Formula: a quadratic is a part [x_0, x_2] of the parabola y = x^2, scaled by s. Steps that are equal in
//   f(x) = x / (1 - a + (a^4 + x^2/4)^(1/4)), a = 0.67, nearly the integral of (1 + 4x^2)^(-1/4), have nearly equal
//   errors: it takes |f(x_2) - f(x_0)| sqrt(s / E) / 2 chords, and x from f by f (1 - b + sqrt(b^2 + f^2/4)), b = 0.39.
//   Where the vertex is between x_0 and x_2, s is limited by E. A cubic is first cut into equal quadratics within E/10,
//   (|b_3 - 3 b_2 + 3 b_1 - b_0|^2 / (432 (E/10)^2))^(1/6) of them; their chords, within 0.9 E, are counted together
//   and spread over all of them.
// Cost: a few square roots per chord.
// Bound: none: f and its inverse are approximations, and the number of chords is that of the limit E -> 0.
// Fails: a curve that turns back on a line has no parabola: it becomes one chord ([Kurbo 2025]). Points of cubics are
//   those of the quadratics.
#pragma once

#include <algorithm>
#include <array>

#include "core/flatten/flattening.hpp"

namespace bezierbench {

struct Levien {
  static constexpr MethodInfo info{.id = "levien",
                                   .label = "Levien's parabola integral",
                                   .problem = Problem::flattening,
                                   .min_degree = 2,
                                   .max_degree = 3,
                                   .flops = "12d",
                                   .citation = "[Levien 2019]"};

  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    using P = Point<double, Dimension>;
    const int n = curve.degree();
    if (n == 2)
      return flatten_pieces<Dimension>(
          1,
          [&](int) {
            return std::array{control_point(curve, 0), control_point(curve, 1), control_point(curve, 2)};
          },
          tolerance, chords);
    const auto b = [&](int i) { return control_point(curve, i); };
    const P third = b(3) - 3 * b(2) + 3 * b(1) - b(0);
    const double in_tenths = third.squaredNorm() / (432 * 0.01 * tolerance * tolerance);
    const double wanted = std::ceil(cube_root(std::sqrt(in_tenths)));  // infinite or NaN where it overflows
    const int count = wanted < most_pieces ? std::max(static_cast<int>(wanted), 1) : most_pieces;
    const double step = 1.0 / count;
    const auto point = [&](double t) { return t == 1 ? b(3) : at(curve, t); };
    flatten_pieces<Dimension>(
        count,
        [&](int k) {
          const double from = k * step;
          const double to = k + 1 == count ? 1 : (k + 1) * step;
          const P start = point(from);
          const P end = point(to);
          // The control point of the quadratic with the mean of the cubic's inner control points.
          const P middle = point(0.5 * (from + to));
          const P inner = (8 * middle - start - end) / 6;  // (p_1 + p_2) / 2
          return std::array{start, P((6 * inner - start - end) / 4), end};
        },
        0.9 * tolerance, chords);
    chords.evaluations += 2 * count;
  }

 private:
  static constexpr int most_pieces = 256;

  template <int Dimension>
  struct Piece {
    std::array<Point<double, Dimension>, 3> b;
    double from, to;       ///< f of both ends
    double x_from, per_x;  ///< of t = (x - x_from) per_x
    double count;          ///< of chords, times 2 sqrt(E)
  };

  template <int Dimension, int Degree>
  static Point<double, Dimension> at(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double t) {
    const double s = 1 - t;
    Point<double, Dimension> point;
    for (int axis = 0; axis < Dimension; ++axis)
      point[axis] = ((curve(axis, 0) * s + 3 * t * curve(axis, 1)) * s + 3 * t * t * curve(axis, 2)) * s +
                    t * t * t * curve(axis, 3);
    return point;
  }

  static double integral(double x) {
    constexpr double a = 0.67;
    return x / (1 - a + std::sqrt(std::sqrt(a * a * a * a + 0.25 * x * x)));
  }
  static double inverse(double f) {
    constexpr double b = 0.39;
    return f * (1 - b + std::sqrt(b * b + 0.25 * f * f));
  }

  template <int Dimension>
  static Piece<Dimension> piece_of(const std::array<Point<double, Dimension>, 3>& b, double root_tolerance) {
    using P = Point<double, Dimension>;
    const P first = b[1] - b[0];
    const P second = b[2] - b[1];
    const P bend = first - second;
    const double cross = std::sqrt(squared_cross_product<Dimension>(P(b[2] - b[0]), bend));
    const double x_from = first.dot(bend) / cross;
    const double x_to = second.dot(bend) / cross;
    const double scale = std::abs(cross / (bend.norm() * (x_to - x_from)));
    Piece<Dimension> piece{b, integral(x_from), integral(x_to), 0, 0, 0};
    piece.x_from = inverse(piece.from);
    piece.per_x = 1 / (inverse(piece.to) - piece.x_from);
    if (!(scale > 0 && std::isfinite(scale) && std::isfinite(piece.per_x))) return piece;
    const double difference = std::abs(piece.to - piece.from);
    const double root = std::sqrt(scale);
    piece.count =
        (x_from < 0) == (x_to < 0) ? difference * root : root_tolerance * difference / integral(root_tolerance / root);
    return piece;
  }

  template <int Dimension, class PieceAt>
  static void flatten_pieces(int pieces, const PieceAt& piece_at, double tolerance, Flattening& chords) {
    const double root = std::sqrt(tolerance);
    std::array<Piece<Dimension>, most_pieces> all;
    double sum = 0;
    for (int k = 0; k < pieces; ++k) {
      all[static_cast<std::size_t>(k)] = piece_of<Dimension>(piece_at(k), root);
      sum += all[static_cast<std::size_t>(k)].count;
    }
    const double wanted = std::max(std::ceil(0.5 * sum / root), 1.0);
    chords.complete = wanted <= max_chords;
    const int count = chords.complete ? static_cast<int>(wanted) : max_chords;
    const double step = sum / count;
    double before = 0;
    int next = 1;
    chords.add(0, all[0].b[0]);
    for (int k = 0; k < pieces; ++k) {
      const auto& piece = all[static_cast<std::size_t>(k)];
      for (; next < count && next * step < before + piece.count; ++next) {
        const double part = (next * step - before) / piece.count;
        const double x = inverse(piece.from + (piece.to - piece.from) * part);
        const double t = std::clamp((x - piece.x_from) * piece.per_x, 0.0, 1.0);
        const double s = 1 - t;
        chords.add((k + t) / pieces,
                   Point<double, Dimension>(s * s * piece.b[0] + 2 * s * t * piece.b[1] + t * t * piece.b[2]));
      }
      before += piece.count;
    }
    chords.add(1, all[static_cast<std::size_t>(pieces) - 1].b[2]);
    chords.evaluations += count - 1;
  }
};

}  // namespace bezierbench
