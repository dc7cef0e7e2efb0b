// SPDX-License-Identifier: MIT
// Formula: the sum of the chords between N + 1 points at equal steps of t, N doubled until its proved error is small
//   enough.
// Cost: N + 1 points, each used again when N is doubled.
// Bound: proved. Over a step of width w let v be the mean of C' (the chord over w) and D = w/2 max|C''|, so that
//   |C' - v| <= D. The chord is shorter than the arc by at most the integral of |C' - v|, w D; and by at most
//   w D^2 / (2 (|v| - D)) where |v| > D, for |C'| - C'.v/|v| <= |part of C' across v|^2 / (2 C'.v/|v|). The roundings
//   of the points are added. Two sums that agree would prove nothing: a curve that turns back next to one of the points
//   gives the same sum for N and 2N.
// Fails: it is slow, with an error of about 1/N^2. Every chord carries the roundings of two points, so many chords
//   carry many.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/points.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"

namespace bezierbench {

struct ChordSum {
  static constexpr int doublings = 10;

  static constexpr MethodInfo info{.id = "chord_sum",
                                   .label = "Chord sums",
                                   .problem = Problem::arc_length,
                                   .form = Form::bernstein,
                                   .promise = "the tolerance, proved, or converged is no",
                                   .flops = "per point n(1+3d) + 2d + 2",
                                   .citation = "[Document 000], section 3.1; bound derived here"};

  template <int Dimension>
  static ArcLength measure(const Curve<Form::bernstein, double, Dimension>& hodograph, double tolerance) {
    const auto curve = curve_of(hodograph);
    const auto prepared = HornerBernstein::prepare(curve);
    int chords = 8 * curve.degree();
    std::vector<Point<double, Dimension>> points;
    for (int k = 0; k <= chords; ++k)
      points.push_back(HornerBernstein::evaluate(prepared, static_cast<double>(k) / chords));
    const double bend = largest_bend(hodograph);
    const double rounding = rounding_of_chord(curve);
    ArcLength best{.error_estimate = std::numeric_limits<double>::infinity()};
    for (int doubling = 0;; ++doubling) {
      auto result = sum_of_chords(points, bend);
      const double roundings = chords * rounding;
      // Twice the chords have twice the roundings: the estimate then exceeds the present one, whatever the tolerance.
      const bool finest = result.error_estimate <= roundings;
      result.error_estimate += roundings;
      if (result.error_estimate < best.error_estimate) best = result;
      best.evaluations = chords + 1;
      best.converged = best.error_estimate <= tolerance * best.length;
      if (best.converged || finest || doubling == doublings) return best;
      points = with_middles(prepared, points);
      chords *= 2;
    }
  }

 private:
  template <class Prepared, int Dimension>
  static std::vector<Point<double, Dimension>> with_middles(const Prepared& prepared,
                                                            const std::vector<Point<double, Dimension>>& points) {
    const auto chords = points.size() - 1;
    std::vector<Point<double, Dimension>> finer;
    for (std::size_t k = 0; k < chords; ++k) {
      finer.push_back(points[k]);
      finer.push_back(
          HornerBernstein::evaluate(prepared, (static_cast<double>(k) + 0.5) / static_cast<double>(chords)));
    }
    finer.push_back(points.back());
    return finer;
  }

  /// The sum of the chords, and how much shorter than the curve it may be.
  template <int Dimension>
  static ArcLength sum_of_chords(const std::vector<Point<double, Dimension>>& points, double bend) {
    const double width = 1 / static_cast<double>(points.size() - 1);
    const double deviation = width / 2 * bend;
    ArcLength result{.length = 0, .error_estimate = 0};
    for (std::size_t k = 1; k < points.size(); ++k) {
      const double chord = (points[k] - points[k - 1]).norm();
      const double rest = chord / width - deviation;
      result.length += chord;
      result.error_estimate += width * deviation * (rest > deviation / 2 ? deviation / (2 * rest) : 1);
    }
    return result;
  }

  /// A bound of |C''|: the largest of its control vectors.
  template <int Dimension>
  static double largest_bend(const Curve<Form::bernstein, double, Dimension>& hodograph) {
    double largest = 0;
    for (int i = 0; i < hodograph.degree(); ++i) {
      double square = 0;
      for (int axis = 0; axis < Dimension; ++axis) {
        const double step = hodograph(axis, i + 1) - hodograph(axis, i);
        square += step * step;
      }
      largest = std::max(largest, hodograph.degree() * std::sqrt(square));
    }
    return largest;
  }
};

}  // namespace bezierbench
