// SPDX-License-Identifier: MIT
// How far a fitted curve may be from the polyline of its data, and whether a segment stays that near.
//
// The tolerance limits the distance of the data from the curve, not of the curve between the data. So the part of the
// curve between the parameters of P_i and P_(i+1) has the limit 5/2 e + s, with the tolerance e and
// s = max(|D_i|, |D_(i+1)|) / 8, D_i = P_(i-1) - 2 P_i + P_(i+1). Every cubic that visits all points at equal steps of
// its parameter, each within e, keeps it. docs/proofs/polyline.md has the proof, and what s is for steps of different
// lengths and at corners.
//
// Closed data go on at their other end. A given direction stands for a point as far before the first as the second is
// behind it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/fit/cubic.hpp"
#include "core/powers.hpp"
#include "core/project/polygon.hpp"

namespace bezierbench {

// The data that fits work on: scaled by a power of two, without repetitions.

template <int Dimension>
struct FitData {
  /// Takes at least one point, its finite `coordinates` point by point.
  explicit FitData(std::span<const double> coordinates) {
    const auto count = coordinates.size() / Dimension;
    const auto given = [&](std::size_t i) {
      Point<double, Dimension> point;
      for (int axis = 0; axis < Dimension; ++axis)
        point[axis] = coordinates[i * Dimension + static_cast<std::size_t>(axis)];
      return point;
    };
    double largest = 0;
    for (const double x : coordinates) largest = std::max(largest, std::abs(x));
    exponent = binary_exponent(largest);
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < count; ++i) {
      if (kept.empty() || given(kept.back()) != given(i)) kept.push_back(i);
      index.push_back(static_cast<int>(kept.size()) - 1);
    }
    original.resize(Dimension, static_cast<Eigen::Index>(kept.size()));
    points.resize(Dimension, original.cols());
    for (Eigen::Index k = 0; k < original.cols(); ++k) {
      original.col(k) = given(kept[static_cast<std::size_t>(k)]);
      for (int axis = 0; axis < Dimension; ++axis) points(axis, k) = std::ldexp(original(axis, k), -exponent);
    }
    closed = original.cols() > 2 && original.col(0) == original.col(original.cols() - 1);
  }

  [[nodiscard]] int count() const { return static_cast<int>(points.cols()); }
  [[nodiscard]] int last() const { return count() - 1; }

  /// The largest change of a coordinate by scaling and scaling back, in scaled units. Only subnormal numbers change.
  [[nodiscard]] double quantum() const { return std::ldexp(1.0, std::max(-1073, -1073 - exponent)); }

  Polygon<Dimension> original;  ///< the given points without repetitions
  Polygon<Dimension> points;    ///< `original` over 2^exponent: at most 1 in magnitude
  std::vector<int> index;       ///< index of each given point in `points`
  int exponent = 0;
  bool closed = false;  ///< the last point equals the first
};

/// The data have a corner where the cosine of their turn is below this. A pentagon's corners turn by 72 degrees, a
/// square's by 90.
inline constexpr double sharp_turn = 0.25;

/// The limit of each step of the polyline of the data, in scaled units. `start` and `end` are the given directions of
/// the curve at its ends, unit vectors.
template <int Dimension>
std::vector<double> step_limits(const FitData<Dimension>& data, double tolerance,
                                const std::optional<Point<double, Dimension>>& start,
                                const std::optional<Point<double, Dimension>>& end) {
  using Vector = Point<double, Dimension>;
  const int last = data.last();
  if (last == 0) return {};
  Polygon<Dimension> steps = Polygon<Dimension>::Zero(Dimension, last + 2);  // the outer two lie beyond the data
  for (int i = 0; i < last; ++i) steps.col(i + 1) = data.points.col(i + 1) - data.points.col(i);
  if (data.closed) {
    steps.col(0) = steps.col(last);
    steps.col(last + 1) = steps.col(1);
  }
  if (start) steps.col(0) = length<Dimension>(steps.col(1)) * *start;
  if (end) steps.col(last + 1) = length<Dimension>(steps.col(last)) * *end;
  const auto corner = [&](int i) {
    const Vector in = steps.col(i);
    const Vector out = steps.col(i + 1);
    return dot<Dimension>(in, out) < sharp_turn * length<Dimension>(in) * length<Dimension>(out);
  };
  const auto inner = [&](int i) {
    return corner(i) ? Vector(Vector::Zero()) : Vector(steps.col(i + 1) - steps.col(i));
  };
  const auto second_difference = [&](int i) -> Vector {
    const int inwards = i == 0 ? 1 : i == last ? -1 : 0;
    if (inwards == 0 || data.closed || (i == 0 ? start : end).has_value()) return inner(i);
    if (last < 3) return last < 2 ? Vector(Vector::Zero()) : inner(1);
    return 2 * inner(i + inwards) - inner(i + 2 * inwards);
  };
  std::vector<double> limits;
  for (int i = 0; i < last; ++i) {
    const double bend = std::max(length<Dimension>(second_difference(i)), length<Dimension>(second_difference(i + 1)));
    const double neighbour = std::max(corner(i) ? 0.0 : length<Dimension>(steps.col(i)),
                                      corner(i + 1) ? 0.0 : length<Dimension>(steps.col(i + 2)));
    const double s = std::min({bend, 2 * length<Dimension>(steps.col(i + 1)), 2 * neighbour}) / 8;
    limits.push_back(2.5 * tolerance + s);
  }
  return limits;
}

/// Whether a cubic is nowhere farther than `limit` from the line segment from 0 to `step`. True is certain up to the
/// roundings of the distances. The distance from a convex set is a convex function, so it is nowhere larger than at the
/// control points of the halves, quarters and so on that decide it.
template <int Dimension>
bool stays_near(const Cubic<Dimension>& b, const Point<double, Dimension>& step, double limit, int max_halvings) {
  const double square = squared<Dimension>(step);
  const auto near = [&](const Point<double, Dimension>& point) {
    const double along = dot<Dimension>(point, step) / square;
    const double share = along > 0 ? std::min(along, 1.0) : 0;  // 0 as well where squares underflow
    return length<Dimension>(point - share * step) <= limit;
  };
  if (near(b[0]) && near(b[1]) && near(b[2]) && near(b[3])) return true;
  const Point<double, Dimension> middle = 0.5 * (b[1] + b[2]);
  const Point<double, Dimension> l1 = 0.5 * (b[0] + b[1]);
  const Point<double, Dimension> l2 = 0.5 * (l1 + middle);
  const Point<double, Dimension> r2 = 0.5 * (b[2] + b[3]);
  const Point<double, Dimension> r1 = 0.5 * (middle + r2);
  const Point<double, Dimension> cut = 0.5 * (l2 + r1);
  if (max_halvings == 0 || !near(b[0]) || !near(cut) || !near(b[3])) return false;
  return stays_near<Dimension>({b[0], l1, l2, cut}, step, limit, max_halvings - 1) &&
         stays_near<Dimension>({cut, r1, r2, b[3]}, step, limit, max_halvings - 1);
}

/// The control points, minus `point`, of the part of a cubic between two parameters, by its blossom.
template <int Dimension>
Cubic<Dimension> part_between(const Cubic<Dimension>& b, const Point<double, Dimension>& point, double from,
                              double to) {
  const auto blossom = [&](double t0, double t1, double t2) {
    Point<double, Dimension> result;
    for (int axis = 0; axis < Dimension; ++axis) {
      const auto at = [&](int j) { return b[static_cast<std::size_t>(j)][axis] - point[axis]; };
      const auto mix = [](double left, double right, double t) { return (1 - t) * left + t * right; };
      const double middle = mix(at(1), at(2), t0);
      result[axis] = mix(mix(mix(at(0), at(1), t0), middle, t1), mix(middle, mix(at(2), at(3), t0), t1), t2);
    }
    return result;
  };
  return {blossom(from, from, from), blossom(from, from, to), blossom(from, to, to), blossom(to, to, to)};
}

/// The number of the first step whose part of the segment is farther from it than its limit; none where all are near.
/// `points` are those of the section, with a parameter each, and one limit less. Roundings count as distance.
template <int Dimension>
std::optional<int> first_departure(const Polygon<Dimension>& points, const std::vector<double>& limits,
                                   const Cubic<Dimension>& cubic, const std::vector<double>& t) {
  constexpr int max_halvings = 8;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const Point<double, Dimension> from = points.col(static_cast<Eigen::Index>(i));
    const Point<double, Dimension> step = points.col(static_cast<Eigen::Index>(i) + 1) - from;
    double largest = 0;
    for (const auto& control : cubic)
      for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(control[axis] - from[axis]));
    const double limit = limits[i] - 0x1p-46 * largest;
    if (!stays_near<Dimension>(part_between<Dimension>(cubic, from, t[i], t[i + 1]), step, limit, max_halvings))
      return static_cast<int>(i);
  }
  return std::nullopt;
}

}  // namespace bezierbench
