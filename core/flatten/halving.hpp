// SPDX-License-Identifier: MIT
// Formula: a piece that a criterion calls flat becomes a chord, any other is halved by de Casteljau's triangle.
//   distance: every control point is within E of the chord, which the hull of the control points then is, too.
//   area: the areas of the triangles between the chord and each control point sum to at most E/2 times the chord.
//   angle: as area; then also the angles of the control polygon with itself turn by less than 15 degrees.
//   length: (polygon)^2 - (chord)^2 <= E^2.
// Source: distance: [Lane and Riesenfeld 1980]. area: [Mononen 2013], nvg__tesselateBezier. angle: [Shemanarev 2005],
//   its curve4_div. length: [Barrett 2009], stbtt__tesselate_cubic.
// Cost: the flops are those of one halving.
// Bound: distance keeps the tolerance, apart from roundings. The others look at lines, not at chords: a curve that
//   turns back along its chord is flat to them.
//   Rational curves are halved in homogeneous coordinates, and a piece with weights of two signs is never flat: its
//   points need not lie in the hull of its control points.
// Fails: parts are halves, quarters, ...: up to twice as many chords as required. Depths end at 16.
#pragma once

#include <algorithm>

#include "core/flatten/flattening.hpp"
#include "core/homogeneous_coordinates.hpp"
#include "core/subdivide/subdivision.hpp"

namespace bezierbench {

template <class Criterion, Form F = Form::bernstein>
struct Halving {
  static constexpr int deepest = 16;
  static constexpr MethodInfo info{.id = Criterion::id,
                                   .label = Criterion::label,
                                   .problem = Problem::flattening,
                                   .form = F,
                                   .min_degree = 1,
                                   .promise = Criterion::promise,
                                   .flops = "3d n(n+1)/2",
                                   .cost_exponent = 2,
                                   .citation = Criterion::citation};

  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    chords.add(0, control_point(curve, 0));
    add(curve, 0, 1, 0, tolerance, chords);
  }
  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::rational, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    chords.add(0, control_point(curve.points, 0));
    add(homogeneous(curve), 0, 1, 0, tolerance, chords);
    const auto end = control_point(curve.points, curve.degree());
    std::copy(end.begin(), end.end(), chords.points.end() - Dimension);
    chords.complete = chords.complete && weights_are_in_range(curve);
  }

 private:
  /// `piece` is in homogeneous coordinates where F is the rational form.
  template <int Axes, int Degree>
  static void add(const Curve<Form::bernstein, double, Axes, Degree>& piece, double from, double to, int depth,
                  double tolerance, Flattening& chords) {
    const bool flat = is_flat(piece, tolerance);
    if (flat || depth == deepest) {
      chords.complete = chords.complete && flat;
      chords.add(to, last_point(piece));
      return;
    }
    ++chords.evaluations;
    const auto halves = split_by_triangle(piece, [](double a, double b) { return 0.5 * a + 0.5 * b; });
    const double middle = 0.5 * (from + to);
    add(halves.left, from, middle, depth + 1, tolerance, chords);
    add(halves.right, middle, to, depth + 1, tolerance, chords);
  }

  template <int Axes, int Degree>
  static bool is_flat(const Curve<Form::bernstein, double, Axes, Degree>& piece, double tolerance) {
    if constexpr (F == Form::rational) {
      const auto seen = over_last_axis(piece);
      return weights_have_one_sign(seen) && Criterion::is_flat(seen.points, tolerance);
    } else {
      return Criterion::is_flat(piece, tolerance);
    }
  }

  template <int Axes, int Degree>
  static auto last_point(const Curve<Form::bernstein, double, Axes, Degree>& piece) {
    const auto last = control_point(piece, piece.degree());
    if constexpr (F == Form::rational) {
      Point<double, Axes - 1> point;
      for (int axis = 0; axis + 1 < Axes; ++axis) point[axis] = last[axis] / last[Axes - 1];
      return point;
    } else {
      return last;
    }
  }
};

struct DistanceCriterion {
  static constexpr std::string_view id = "halving_distance";
  static constexpr std::string_view label = "Halving by the distance of control points";
  static constexpr std::string_view promise = "the tolerance, apart from roundings";
  static constexpr std::string_view citation = "[Lane and Riesenfeld 1980]";

  template <int Dimension, int Degree>
  static bool is_flat(const Curve<Form::bernstein, double, Dimension, Degree>& piece, double tolerance) {
    const int n = piece.degree();
    const auto from = control_point(piece, 0);
    const auto to = control_point(piece, n);
    for (int i = 1; i < n; ++i)
      if (!(squared_distance_to_segment(control_point(piece, i), from, to) <= tolerance * tolerance)) return false;
    return true;
  }
};

struct AreaCriterion {
  static constexpr std::string_view id = "halving_area";
  static constexpr std::string_view label = "Halving by the area beside the chord";
  static constexpr std::string_view promise = {};
  static constexpr std::string_view citation = "[Mononen 2013]";

  template <int Dimension, int Degree>
  static bool is_flat(const Curve<Form::bernstein, double, Dimension, Degree>& piece, double tolerance) {
    const int n = piece.degree();
    const auto from = control_point(piece, 0);
    const Point<double, Dimension> chord = control_point(piece, n) - from;
    double areas = 0;
    for (int i = 1; i < n; ++i) {
      const Point<double, Dimension> offset = control_point(piece, i) - from;
      areas += std::sqrt(squared_cross_product<Dimension>(offset, chord));
    }
    return areas * areas <= tolerance * tolerance * chord.squaredNorm();
  }
};

struct AngleCriterion {
  static constexpr std::string_view id = "halving_angle";
  static constexpr std::string_view label = "Halving by angle and distance";
  static constexpr std::string_view promise = {};
  static constexpr std::string_view citation = "[Shemanarev 2005]";
  static constexpr double squared_tangent = 0.0717967697244908;  ///< of 15 degrees

  template <int Dimension, int Degree>
  static bool is_flat(const Curve<Form::bernstein, double, Dimension, Degree>& piece, double tolerance) {
    if (!AreaCriterion::is_flat(piece, tolerance)) return false;
    for (int i = 2; i <= piece.degree(); ++i) {
      const Point<double, Dimension> before = control_point(piece, i - 1) - control_point(piece, i - 2);
      const Point<double, Dimension> after = control_point(piece, i) - control_point(piece, i - 1);
      const double cosine = before.dot(after);
      const bool aligned =
          cosine >= 0 && squared_cross_product<Dimension>(before, after) <= squared_tangent * cosine * cosine;
      if (!aligned) return false;
    }
    return true;
  }
};

struct LengthCriterion {
  static constexpr std::string_view id = "halving_length";
  static constexpr std::string_view label = "Halving by the length of the control polygon";
  static constexpr std::string_view promise = {};
  static constexpr std::string_view citation = "[Barrett 2009]";

  template <int Dimension, int Degree>
  static bool is_flat(const Curve<Form::bernstein, double, Dimension, Degree>& piece, double tolerance) {
    const int n = piece.degree();
    double polygon = 0;
    for (int i = 0; i < n; ++i) polygon += (control_point(piece, i + 1) - control_point(piece, i)).norm();
    return polygon * polygon - (control_point(piece, n) - control_point(piece, 0)).squaredNorm() <=
           tolerance * tolerance;
  }
};

}  // namespace bezierbench
