// SPDX-License-Identifier: MIT
#include "experiments/guarantees/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "reference/rational.hpp"

namespace bezierbench::guarantees {
namespace {

using reference::Rational;

/// From the point to a control point, exactly, and rounded.
struct Offset {
  Rational x;
  Rational y;
  double rounded_x;
  double rounded_y;
};

int sign(const Rational& value) { return sgn(value.numerator); }
Rational cross(const Offset& a, const Offset& b) { return a.x * b.y - a.y * b.x; }
Rational dot(const Offset& a, const Offset& b) { return a.x * b.x + a.y * b.y; }

/// The sign of the cross product; from rounded numbers where these decide. Their four roundings and the three of the
/// formula change it by less than 8 u (|a_x b_y| + |a_y b_x|), and a product that underflows by far less than 1e-300.
int turn(const Offset& a, const Offset& b) {
  const double left = a.rounded_x * b.rounded_y;
  const double right = a.rounded_y * b.rounded_x;
  const double margin = 0x1p-50 * (std::abs(left) + std::abs(right)) + 1e-300;
  const double difference = left - right;
  if (difference > margin) return 1;
  if (difference < -margin) return -1;
  return sign(cross(a, b));
}

/// Whether all offsets lie within less than half a turn to the left of this one, or along it: then a line through the
/// point has all control points on one side.
bool bounds_all(const Offset& first, std::span<const Offset> offsets) {
  return std::ranges::all_of(offsets, [&](const Offset& other) {
    const int side = turn(first, other);
    return side > 0 || (side == 0 && sign(dot(first, other)) > 0);
  });
}

/// The distance of the origin from the segment between the ends of two offsets, squared.
Rational squared_distance(const Offset& a, const Offset& b) {
  const Offset along{b.x - a.x, b.y - a.y, 0, 0};
  const Rational projected = Rational{} - dot(a, along);
  const Rational length = dot(along, along);
  if (sign(projected) <= 0) return dot(a, a);
  if (!less(projected, length)) return dot(b, b);
  const Rational area = cross(a, b);
  const Rational square = area * area;
  return {square.numerator, length.numerator, square.exponent - length.exponent};
}

}  // namespace

double distance_outside(const PlanePoint& point, std::span<const PlanePoint> controls) {
  std::vector<Offset> offsets;
  for (const auto& control : controls) {
    if (control.x == point.x && control.y == point.y) return 0;
    offsets.push_back({reference::exactly(control.x) - reference::exactly(point.x),
                       reference::exactly(control.y) - reference::exactly(point.y), control.x - point.x,
                       control.y - point.y});
  }
  if (std::ranges::none_of(offsets, [&](const Offset& one) { return bounds_all(one, offsets); })) return 0;
  Rational least = dot(offsets[0], offsets[0]);
  for (std::size_t i = 0; i < offsets.size(); ++i)
    for (std::size_t k = i + 1; k < offsets.size(); ++k) {
      const Rational one = squared_distance(offsets[i], offsets[k]);
      if (less(one, least)) least = one;
    }
  return std::max(square_root(reference::binary64, least), std::numeric_limits<double>::denorm_min());
}

}  // namespace bezierbench::guarantees
