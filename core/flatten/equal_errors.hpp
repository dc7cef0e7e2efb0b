// SPDX-License-Identifier: MIT
// Formula: of a cubic over [a, b], the inner control points p_1 = C(a) + h/3 C'(a) and p_2 = C(b) - h/3 C'(b) are at
//   distances d_1, d_2 from the chord, a segment. No point of the piece is farther than e = (16 max + 11 min)/36 of
//   these, or 4/9 of the larger one where both feet are inside and the points on different sides. Equal steps, half of
//   Wang's count and at least 4, are measured; sqrt(e/E) is the number of chords that a step takes, since e grows with
//   the square of a small step. Their sum, rounded up, is the number of chords, and each gets an equal share, with the
//   steps' numbers spread evenly over them. These chords are measured, and if one is too far, they are the steps of
//   another round; after 8 rounds chords that are too far are halved.
// Source: the inner control points are those of [Farin 2002], cubic Hermite interpolation; the rest is derived here.
//   The distance from a segment is convex, so that the point at t is at most 3 t (1-t) ((1-t) d_1 + t d_2) away, a
//   convex function of d_1 and d_2 whose maximum over t is 3/4 d where both are d and 4/9 d where one is 0; between
//   these it is below their mean. On different sides the two parts cancel.
// Cost: about 30 d flops, 2 square roots and a division for each chord and round, mostly 2 rounds.
// Bound: the tolerance, where it is above 2^-44 of the largest coordinate and 2^-1040. Chords are measured against
//   E (1 - 2^-20) - 2^-45 max|b|: the power form that is evaluated, and what is made of it, are off by less than
//   2^-46 max|b|, by fewer than 60 roundings of numbers below 12 max|b|. Reversed curves have the same points: of both
//   directions, the one whose control points come first in lexicographic order is flattened.
// Fails: for degrees above 3.
#pragma once

#include <algorithm>
#include <array>

#include "core/flatten/flattening.hpp"

namespace bezierbench {

struct EqualErrors {
  static constexpr bool keeps_tolerance = true;
  static constexpr bool reverses = true;
  static constexpr MethodInfo info{.id = "equal_errors",
                                   .label = "Equal errors by measured chords",
                                   .problem = Problem::flattening,
                                   .min_degree = 1,
                                   .max_degree = 3,
                                   .promise = "the tolerance, and the same points for the reversed curve",
                                   .flops = "30d",
                                   .citation = "[Farin 2002], cubic Hermite interpolation; bound derived here"};

  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    const int n = curve.degree();
    const double order = order_of_ends(curve);
    Run<Dimension> run(curve, order > 0, tolerance, chords);
    run.add_end(0, run.first);
    const double wanted = 0.5 * run.wang_count();
    const int parts = static_cast<int>(std::min(wanted / (most_steps / 2) + 1, 1024.0));
    const int steps = static_cast<int>(std::clamp(std::ceil(wanted / parts), 4.0, most_steps / 2.0));
    const double whole = order == 0 && n > 1 ? 0.5 : 1;  // a curve that is its own reverse returns on its first half
    for (int k = 0; k < parts; ++k) run.flatten_part(whole * k / parts, whole * (k + 1) / parts, steps, n);
    if (whole < 1)
      append_mirrored(chords, Dimension);
    else if (order > 0)
      reverse(chords, Dimension);
  }

 private:
  static constexpr int most_steps = 256;
  static constexpr int deepest = 40;

  /// Below 0 where the control points come before the reversed ones in lexicographic order, above 0 where after them.
  template <int Dimension, int Degree>
  static double order_of_ends(const Curve<Form::bernstein, double, Dimension, Degree>& curve) {
    const int n = curve.degree();
    for (int i = 0; 2 * i < n; ++i)
      for (int axis = 0; axis < Dimension; ++axis)
        if (curve(axis, i) != curve(axis, n - i)) return curve(axis, i) - curve(axis, n - i);
    return 0;
  }

  static void append_mirrored(Flattening& chords, int dimension) {
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t k = chords.t.size() - 1; k > 0; --k) {
      chords.t.push_back(1 - chords.t[k - 1]);
      for (std::size_t axis = 0; axis < d; ++axis) chords.points.push_back(chords.points[(k - 1) * d + axis]);
    }
  }

  static void reverse(Flattening& chords, int dimension) {
    std::ranges::reverse(chords.t);
    for (double& t : chords.t) t = 1 - t;
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t low = 0, high = chords.points.size() - d; low < high; low += d, high -= d)
      std::swap_ranges(&chords.points[low], &chords.points[low] + d, &chords.points[high]);
  }

  template <int Dimension>
  struct Run {
    using P = Point<double, Dimension>;
    struct End {
      double t;
      P point;
      P derivative;
    };
    struct Measure {
      double square;  ///< of e over the limit
      bool inside;    ///< whether the feet of the inner control points are on the chord

      /// How many chords the step takes. A step that turns back takes few, but where it turns.
      [[nodiscard]] double chords() const {
        const double count = std::sqrt(std::sqrt(square));
        return inside ? count : std::min(count, 2.0);
      }
    };

    template <int Degree>
    Run(const Curve<Form::bernstein, double, Dimension, Degree>& curve, bool is_reversed, double tolerance,
        Flattening& result)
        : reversed(is_reversed), chords(result) {
      const int n = curve.degree();
      double largest = 0;
      for (int i = 0; i <= n; ++i)
        for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(curve(axis, i)));
      const int exponent = largest > 0 ? std::clamp(std::ilogb(largest), -1021, 1021) : 0;
      unit = std::ldexp(1, exponent);
      const double scale = std::ldexp(1, -exponent);
      const auto b = [&](int i) { return P(scale * control_point(curve, reversed ? n - i : i)); };
      first = b(0);
      last = b(n);
      limit = scale * tolerance * (1 - 0x1p-20) - 0x1p-45 * scale * largest;
      if (!(limit >= 0.5 * scale * tolerance) || tolerance < 0x1p-1040) {
        chords.complete = false;
        limit = std::max(0.5 * scale * tolerance, 0x1p-44 * scale * largest);
      }
      const P zero = P::Zero();
      if (n == 3)
        powers = {b(0), 3 * (b(1) - b(0)), 3 * ((b(2) - b(1)) - (b(1) - b(0))), (b(3) - b(0)) - 3 * (b(2) - b(1))};
      else if (n == 2)
        powers = {b(0), 2 * (b(1) - b(0)), (b(2) - b(1)) - (b(1) - b(0)), zero};
      else
        powers = {b(0), b(1) - b(0), zero, zero};
    }

    void add_end(double t, const P& point) { chords.add(t, P(unit * point)); }

    /// C'' is largest at an end.
    double wang_count() const {
      const double second = std::max((2 * powers[2]).norm(), (2 * powers[2] + 6 * powers[3]).norm());
      return std::sqrt(0.125 * second / limit);
    }

    End end_at(double t) const {
      if (t == 1) return {t, last, powers[1] + 2 * powers[2] + 3 * powers[3]};
      return {t, powers[0] + t * (powers[1] + t * (powers[2] + t * powers[3])),
              powers[1] + t * (2 * powers[2] + 3 * t * powers[3])};
    }

    /// The error of a chord.
    Measure measured(const End& from, const End& to) const {
      const double third = (to.t - from.t) * (1.0 / 3);
      const P chord = to.point - from.point;
      const P one = third * from.derivative;
      const P other = chord - third * to.derivative;
      const double squared_length = chord.squaredNorm();
      const double along_one = one.dot(chord);
      const double along_other = other.dot(chord);
      const bool inside = along_one >= 0 && along_one <= squared_length && along_other >= 0 &&
                          along_other <= squared_length && squared_length > 0;
      if constexpr (Dimension == 2) {
        if (inside) {
          const double d1 = chord[0] * one[1] - chord[1] * one[0];
          const double d2 = chord[0] * other[1] - chord[1] * other[0];
          const double more = std::max(std::abs(d1), std::abs(d2));
          const double less = d1 * d2 < 0 ? 0 : std::min(std::abs(d1), std::abs(d2));
          const double e = (16 * more + 11 * less) * (1.0 / 36);
          return {e * e / (squared_length * limit * limit), true};
        }
      }
      const P zero = P::Zero();
      const double s1 = squared_distance_to_segment<Dimension>(one, zero, chord);
      const double s2 = squared_distance_to_segment<Dimension>(other, zero, chord);
      const double e = (16 * std::sqrt(std::max(s1, s2)) + 11 * std::sqrt(std::min(s1, s2))) * (1.0 / 36);
      return {e * e / (limit * limit), inside};
    }

    void flatten_part(double from, double to, int steps, int degree) {
      std::array<End, most_steps + 1> ends;
      std::array<double, most_steps + 1> share;  ///< chords of the steps before
      ends[0] = end_at(from);
      if (from == 0) ends[0].point = first;
      const End last_end = end_at(to);
      const double whole = degree < 2 ? 0 : measured(ends[0], last_end).square;
      if (whole <= 1) {
        chords.evaluations += 2;
        add_end(last_end.t, last_end.point);
        return;
      }
      for (int k = 1; k < steps; ++k) ends[at(k)] = end_at(from + (to - from) * (1.0 * k / steps));
      int count = steps;
      ends[at(count)] = last_end;
      chords.evaluations += steps + 1;
      for (int round = 0;; ++round) {
        share[0] = 0;
        double largest = 0;
        for (int k = 0; k < count; ++k) {
          const auto measure = measured(ends[at(k)], ends[at(k + 1)]);
          largest = std::max(largest, measure.square);
          share[at(k + 1)] = share[at(k)] + measure.chords();
        }
        if (round > 0 && largest <= 1) {
          for (int k = 1; k <= count; ++k) add_end(ends[at(k)].t, ends[at(k)].point);
          return;
        }
        if (round == most_rounds) break;
        const double wanted = std::ceil(share[at(count)] * spare);
        if (!(wanted <= most_steps)) break;
        const int next = std::max(static_cast<int>(wanted), 2);
        std::array<double, most_steps> t;
        for (int i = 1, k = 0; i < next; ++i) {
          const double target = share[at(count)] * i / next;
          while (k + 1 < count && share[at(k + 1)] < target) ++k;
          const double width = share[at(k + 1)] - share[at(k)];
          const double part = width > 0 ? std::min((target - share[at(k)]) / width, 1.0) : 1;
          t[at(i)] = ends[at(k)].t + part * (ends[at(k + 1)].t - ends[at(k)].t);
        }
        for (int i = 1; i < next; ++i) ends[at(i)] = end_at(t[at(i)]);
        count = next;
        ends[at(count)] = last_end;
        chords.evaluations += count - 1;
      }
      for (int k = 0; k < count; ++k) add_halved(ends[at(k)], ends[at(k + 1)], 0);
    }

    /// Adds the chord, or halves that are near enough.
    void add_halved(const End& from, const End& to, int depth) {
      const double middle = 0.5 * (from.t + to.t);
      if (measured(from, to).square <= 1 || depth == deepest || static_cast<int>(chords.t.size()) >= max_chords ||
          !(from.t < middle && middle < to.t)) {
        chords.complete = chords.complete && measured(from, to).square <= 1;
        if (to.t > chords.t.back()) add_end(to.t, to.point);
        return;
      }
      ++chords.evaluations;
      const End half = end_at(middle);
      add_halved(from, half, depth + 1);
      add_halved(half, to, depth + 1);
    }

    static constexpr int most_rounds = 8;
    static constexpr double spare = 1.01;
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }

    bool reversed;
    Flattening& chords;
    P first;
    P last;
    std::array<P, 4> powers;
    double unit;   ///< what the curve is measured in: a power of two
    double limit;  ///< of measured errors
  };
};

}  // namespace bezierbench
