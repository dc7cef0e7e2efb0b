// SPDX-License-Identifier: MIT
#include "reference/companion/fit_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "reference/companion/projection.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::reference {
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
