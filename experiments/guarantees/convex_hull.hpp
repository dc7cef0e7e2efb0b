// SPDX-License-Identifier: MIT
// The distance of a point in the plane from the convex hull of other points.
#pragma once

#include <span>

namespace bezierbench::guarantees {

struct PlanePoint {
  double x;
  double y;
};

/// The distance of a point from the convex hull of at least one point: 0 exactly where it lies in the hull or on its
/// boundary, else above 0 and right to a few roundings, unless it underflows: then the smallest subnormal.
double distance_outside(const PlanePoint& point, std::span<const PlanePoint> controls);

}  // namespace bezierbench::guarantees
