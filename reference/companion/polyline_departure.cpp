// SPDX-License-Identifier: MIT
// In doubles: what is measured is taken from a data point, and its roundings are bounded.
#include "reference/companion/polyline_departure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "reference/companion/projection.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::reference {

namespace {

using Vector = std::array<double, 3>;  // coordinates beyond the dimension are 0
using Cubic = std::array<Vector, 4>;

Vector sum(double a, const Vector& u, double b, const Vector& v) {
  return {a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
}
Vector difference(const Vector& u, const Vector& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }
Vector middle(const Vector& u, const Vector& v) { return sum(0.5, u, 0.5, v); }
double inner_product(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
double length(const Vector& v) { return std::sqrt(inner_product(v, v)); }

/// The distance of a point from the line segment from 0 to `step`.
double distance(const Vector& point, const Vector& step) {
  const double square = inner_product(step, step);
  const double share = square > 0 ? std::clamp(inner_product(point, step) / square, 0.0, 1.0) : 0;
  return length(sum(1, point, -share, step));
}

/// Raises `largest` to the largest distance of the cubic from the line segment from 0 to `step`, up to 2^-17 of it and
/// `roundings`. The distance from a convex set is convex, so that it is nowhere larger than at a control point.
void raise_to_distance(const Cubic& b, const Vector& step, double roundings, double& largest) {
  largest = std::max({largest, distance(b[0], step), distance(b[3], step)});
  if (std::max(distance(b[1], step), distance(b[2], step)) <= largest * (1 + 0x1p-17) + roundings) return;
  const auto centre = middle(b[1], b[2]);
  const auto left = middle(b[0], b[1]);
  const auto right = middle(b[2], b[3]);
  const auto left_middle = middle(left, centre);
  const auto right_middle = middle(centre, right);
  const auto cut = middle(left_middle, right_middle);
  raise_to_distance({b[0], left, left_middle, cut}, step, roundings, largest);
  raise_to_distance({cut, right_middle, right, b[3]}, step, roundings, largest);
}

/// The part of a cubic between two parameters, by its blossom.
Cubic part_of(const Cubic& b, double from, double to) {
  const auto blossom = [&b](double t0, double t1, double t2) {
    const auto between = [](const Vector& u, const Vector& v, double t) { return sum(1 - t, u, t, v); };
    const auto centre = between(b[1], b[2], t0);
    return between(between(between(b[0], b[1], t0), centre, t1), between(centre, between(b[2], b[3], t0), t1), t2);
  };
  return {blossom(from, from, from), blossom(from, from, to), blossom(from, to, to), blossom(to, to, to)};
}

/// Vectors of `coordinates`, over 2^exponent.
std::vector<Vector> vectors_of(int dimension, std::span<const double> coordinates, int exponent) {
  const auto d = static_cast<std::size_t>(dimension);
  std::vector<Vector> result(coordinates.size() / d, Vector{});
  for (std::size_t k = 0; k < coordinates.size(); ++k) result[k / d][k % d] = std::ldexp(coordinates[k], -exponent);
  return result;
}

/// The limits of the steps between `points`, consecutive ones different.
std::vector<double> limits_of(const std::vector<Vector>& points, double tolerance) {
  const std::size_t count = points.size() - 1;
  const bool closed = count > 1 && points.front() == points.back();
  std::vector<Vector> steps(count + 2, Vector{});  // the outer two lie beyond the data
  for (std::size_t i = 0; i < count; ++i) steps[i + 1] = difference(points[i + 1], points[i]);
  if (closed) {
    steps.front() = steps[count];
    steps.back() = steps[1];
  }
  std::vector<double> reach_back(count + 1);   // for each point, the length of the step before, 0 at a corner
  std::vector<double> reach_ahead(count + 1);  // likewise of the step after
  std::vector<Vector> bends(count + 1, Vector{});
  for (std::size_t i = 0; i <= count; ++i) {
    const double before = length(steps[i]);
    const double after = length(steps[i + 1]);
    if (inner_product(steps[i], steps[i + 1]) < 0.25 * before * after) continue;
    reach_back[i] = before;
    reach_ahead[i] = after;
    bends[i] = difference(steps[i + 1], steps[i]);
  }
  if (!closed && count < 3) {
    bends.front() = bends.back() = count == 2 ? bends[1] : Vector{};
  } else if (!closed) {
    bends.front() = sum(2, bends[1], -1, bends[2]);
    bends.back() = sum(2, bends[count - 1], -1, bends[count - 2]);
  }
  double largest = 0;
  for (const Vector& point : points) largest = std::max(largest, length(point));
  std::vector<double> limits;
  for (std::size_t i = 0; i < count; ++i) {
    const double bend = std::max(length(bends[i]), length(bends[i + 1]));
    const double neighbour = std::max(reach_back[i], reach_ahead[i + 1]);
    limits.push_back(2.5 * tolerance + std::min({bend, 2 * length(steps[i + 1]), 2 * neighbour}) / 8 +
                     0x1p-50 * largest);
  }
  return limits;
}

class Measured {
 public:
  explicit Measured(std::vector<Vector> control_points) : b_(std::move(control_points)), chords_(b_.size() / 4, 0.0) {}

  /// Adds the part of the curve between two places, whose step leads from `point` on.
  void add(const NearPlace& one, const NearPlace& other, const Vector& point, const Vector& step, double limit) {
    const bool ascends = one.segment < other.segment || (one.segment == other.segment && one.t <= other.t);
    const auto& first = ascends ? one : other;
    const auto& last = ascends ? other : one;
    chords_[static_cast<std::size_t>(other.segment)] += length(step);
    double largest = 0;
    double magnitude = 0;
    for (int s = first.segment; s <= last.segment; ++s) {
      Cubic from_point;
      for (std::size_t j = 0; j < 4; ++j) {
        from_point[j] = difference(b_[4 * static_cast<std::size_t>(s) + j], point);
        for (const double x : from_point[j]) magnitude = std::max(magnitude, std::abs(x));
      }
      const auto part = part_of(from_point, s == first.segment ? first.t : 0, s == last.segment ? last.t : 1);
      raise_to_distance(part, step, 0x1p-46 * magnitude, largest);
      if (s == one.segment) largest = std::max(largest, length(ascends ? part.front() : part.back()));
    }
    distance_ = std::max(distance_, largest);
    const double certain = largest - 0x1p-46 * magnitude;
    if (certain > 0) over_limit_ = std::max(over_limit_, certain / limit);
  }

  [[nodiscard]] Departure result(int exponent) const {
    double handle = 0;
    for (std::size_t s = 0; s < chords_.size(); ++s) {
      const double longer = std::max(length(difference(b_[4 * s + 1], b_[4 * s])),  //
                                     length(difference(b_[4 * s + 2], b_[4 * s + 3])));
      if (longer > 0) handle = std::max(handle, longer / chords_[s]);
    }
    return {std::ldexp(distance_, exponent), over_limit_, handle};
  }

 private:
  std::vector<Vector> b_;
  std::vector<double> chords_;  ///< for each segment, the length of the polyline beside it
  double distance_ = 0;
  double over_limit_ = 0;
};

}  // namespace

Departure departure_from_polyline(int dimension, std::span<const double> points, std::span<const double> control_points,
                                  std::span<const NearPlace> places, double tolerance) {
  double most = 0;
  for (const auto& coordinates : {points, control_points})
    for (const double x : coordinates) most = std::max(most, std::abs(x));
  int exponent = 0;
  std::frexp(most, &exponent);
  std::vector<Vector> kept;
  std::vector<NearPlace> kept_places;
  const auto all = vectors_of(dimension, points, exponent);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!kept.empty() && kept.back() == all[i]) {
      kept_places.back() = places[i];
      continue;
    }
    kept.push_back(all[i]);
    kept_places.push_back(places[i]);
  }
  kept_places.front() = {0, 0};
  kept_places.back() = {static_cast<int>(control_points.size()) / (4 * dimension) - 1, 1};
  const auto limits = limits_of(kept, std::ldexp(tolerance, -exponent));
  Measured measured(vectors_of(dimension, control_points, exponent));
  for (std::size_t i = 0; i < limits.size(); ++i)
    measured.add(kept_places[i], kept_places[i + 1], kept[i], difference(kept[i + 1], kept[i]), limits[i]);
  return measured.result(exponent);
}

namespace {

class Distances {
 public:
  Distances(int dimension, std::span<const double> points, std::span<const double> control_points)
      : d_(static_cast<std::size_t>(dimension)), points_(points), control_points_(control_points) {}

  /// The distance to one place of the curve, an upper bound of the distance to the curve.
  Rational squared_at(std::size_t i, const NearPlace& place) {
    const auto at = exact_.point(segment(static_cast<std::size_t>(place.segment)), place.t);
    Rational sum;
    for (std::size_t axis = 0; axis < d_; ++axis) {
      const auto offset = at.coordinate(static_cast<int>(axis)) - exactly(point(i)[axis]);
      sum = sum + offset * offset;
    }
    return sum;
  }

  /// The least distance to any segment, given that it is at most `bound`.
  [[nodiscard]] Rational least_squared(std::size_t i, Rational bound) const {
    for (std::size_t s = 0; s < control_points_.size() / (4 * d_); ++s) {
      if (less(bound, squared_to_box(i, s))) continue;
      const auto squared = projection(segment(s), point(i)).foot().distance_squared;
      if (less(squared, bound)) bound = squared;
    }
    return bound;
  }

 private:
  [[nodiscard]] std::span<const double> point(std::size_t i) const { return points_.subspan(i * d_, d_); }
  [[nodiscard]] CurveView<double> segment(std::size_t s) const {
    return {Form::bernstein, static_cast<int>(d_), 3, control_points_.subspan(4 * d_ * s, 4 * d_)};
  }

  /// The distance to the box around the control points, which holds the segment: a lower bound.
  [[nodiscard]] Rational squared_to_box(std::size_t i, std::size_t s) const {
    Rational sum;
    for (std::size_t axis = 0; axis < d_; ++axis) {
      const double x = point(i)[axis];
      double low = x;
      double high = x;
      const auto b = segment(s);
      if (const auto [least, most] = std::minmax({b(static_cast<int>(axis), 0), b(static_cast<int>(axis), 1),
                                                  b(static_cast<int>(axis), 2), b(static_cast<int>(axis), 3)});
          x < least)
        low = least;
      else if (x > most)
        high = most;
      const auto gap = exactly(low) - exactly(high);
      sum = sum + gap * gap;
    }
    return sum;
  }

  std::size_t d_;
  std::span<const double> points_;
  std::span<const double> control_points_;
  ExactCurve exact_;
};

}  // namespace

Rational largest_squared_distance(int dimension, std::span<const double> points, std::span<const double> control_points,
                                  std::span<const NearPlace> places) {
  Distances distances(dimension, points, control_points);
  std::vector<Rational> bounds;
  for (std::size_t i = 0; i < places.size(); ++i) bounds.push_back(distances.squared_at(i, places[i]));
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return less(bounds[b], bounds[a]); });
  Rational largest;
  for (const auto i : order) {
    if (!less(largest, bounds[i])) break;  // bounds fall, so no later point is farther
    const auto squared = distances.least_squared(i, bounds[i]);
    if (less(largest, squared)) largest = squared;
  }
  return largest;
}

}  // namespace bezierbench::reference
