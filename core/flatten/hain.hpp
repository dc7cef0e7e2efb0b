// SPDX-License-Identifier: MIT
// Formula: from the start of what remains, with s_2 the distance of b_2 from the line through b_0 and b_1, a chord
//   spans t = 2 sqrt(E / (3 |s_2|)), the length of a parabola. About an inflection at t_i, with s_3 the distance of b_3
//   from the tangent there after a split, a chord spans t_i +- (1 - t_i) (E / |s_3|)^(1/3).
// Source: the double root and points without a tangent as in the library lyon.
// Cost: a split, 6 d n flops, and a square root per chord.
// Bound: none: the third-order term of a step is neglected.
// Fails: at wide tolerances, and near inflections that the ranges do not cover; a curve that starts along b_2 - b_0
//   there takes one chord to its end ([Lyon 2020]). In space no inflection is sought.
#pragma once

#include <algorithm>
#include <array>

#include "core/flatten/flattening.hpp"
#include "core/subdivide/subdivision.hpp"

namespace bezierbench {

struct Hain {
  static constexpr MethodInfo info{.id = "hain",
                                   .label = "Hain's parabolas and inflections",
                                   .problem = Problem::flattening,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .flops = "18d",
                                   .citation = "[Hain et al. 2005]"};

  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    const auto ranges = flat_ranges(curve, tolerance);
    auto rest = curve;
    double t = 0;
    chords.add(0, control_point(curve, 0));
    while (static_cast<int>(chords.t.size()) <= max_chords) {
      double next = 1;
      bool flat = false;
      for (const auto& [from, to] : ranges) {
        if (from <= t && t < to) {
          next = std::min(to, 1.0);
          flat = true;
          break;
        }
        if (t < from) next = std::min(next, from);
      }
      const double left = 1 - t;
      double step = (next - t) / left;
      if (!flat) step = std::min(step, parabola_step(rest, tolerance));
      ++chords.evaluations;
      if (!(step < nearly_one)) break;
      rest = split_by_triangle(rest, [step](double a, double b) { return (1 - step) * a + step * b; }).right;
      t += step * left;
      chords.add(t, control_point(rest, 0));
    }
    chords.complete = static_cast<int>(chords.t.size()) <= max_chords;
    chords.add(1, control_point(curve, 3));
  }

 private:
  static constexpr double nearly_one = 0.9999;
  struct Range {
    double from;
    double to;
  };

  template <int Dimension, int Degree>
  static double parabola_step(const Curve<Form::bernstein, double, Dimension, Degree>& rest, double tolerance) {
    using P = Point<double, Dimension>;
    const auto start = control_point(rest, 0);
    const P v1 = control_point(rest, 1) - start;
    const P v2 = control_point(rest, 2) - start;
    const double cross = std::sqrt(squared_cross_product<Dimension>(v1, v2));
    return cross == 0 ? 1 : 2 * std::sqrt(tolerance * v1.norm() / (3 * cross));
  }

  /// Empty ranges, from = to = 2, stand for inflections that there are not.
  template <int Dimension, int Degree>
  static std::array<Range, 2> flat_ranges(const Curve<Form::bernstein, double, Dimension, Degree>& curve,
                                          double tolerance) {
    std::array<Range, 2> ranges{Range{2, 2}, Range{2, 2}};
    if constexpr (Dimension == 2) {
      using P = Point<double, 2>;
      const auto cross_product = [](const P& p, const P& q) { return p[0] * q[1] - p[1] * q[0]; };
      const auto b = [&](int i) { return control_point(curve, i); };
      const P first = b(1) - b(0);
      const P second = b(2) - 2 * b(1) + b(0);
      const P third = b(3) - 3 * b(2) + 3 * b(1) - b(0);
      const double quadratic = cross_product(second, third);
      const double linear = cross_product(first, third);
      const double constant = cross_product(first, second);
      const double discriminant = linear * linear - 4 * quadratic * constant;
      if (discriminant < 0) return ranges;
      const double sum = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
      std::array<double, 2> roots{quadratic == 0 ? 2 : sum / quadratic,
                                  sum == 0 ? (constant == 0 ? 0 : 2) : constant / sum};
      std::ranges::sort(roots);
      for (std::size_t k = 0; k < 2; ++k)
        if (roots[k] >= 0 && roots[k] < 1) ranges[k] = flat_range(curve, roots[k], tolerance);
    }
    return ranges;
  }

  template <int Degree>
  static Range flat_range(const Curve<Form::bernstein, double, 2, Degree>& curve, double t, double tolerance) {
    using P = Point<double, 2>;
    const auto after = split_by_triangle(curve, [t](double a, double b) { return (1 - t) * a + t * b; }).right;
    const auto start = control_point(after, 0);
    P tangent = control_point(after, 1) - start;
    if (tangent.squaredNorm() == 0) tangent = control_point(after, 2) - start;
    const P end = control_point(after, 3) - start;
    const double distance = std::sqrt(squared_cross_product<2>(tangent, end)) / tangent.norm();
    if (!(distance > 0)) return {-1, 2};
    const double reach = (1 - t) * cube_root(tolerance / distance);
    return {t - reach, t + reach};
  }
};

}  // namespace bezierbench
