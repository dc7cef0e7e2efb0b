// SPDX-License-Identifier: MIT
// in_convex_hull: in the plane, p(t) lies in the convex hull of the control points for t in [0,1], wherever it is
// finite. Decided exactly. Rounding a point of a segment to numbers moves it off the segment, so that no method keeps
// this; what a search finds is the distance outside, in ulp of the largest coordinate.
#pragma once

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/convex_hull.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct InConvexHull {
  static constexpr Property property = Property::in_convex_hull;
  static constexpr bool in_the_plane = true;

  static void fit(Case<Scalar>& input) { input.t = into_unit_interval(input.t); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto point = method.point(input.coefficients, input.t);
    if (!all_finite(point)) return std::nullopt;
    Scalar largest = 0;
    std::vector<PlanePoint> controls;
    for (int i = 0; i <= input.degree(); ++i) {
      controls.push_back({static_cast<double>(input(0, i)), static_cast<double>(input(1, i))});
      largest = std::max({largest, std::abs(input(0, i)), std::abs(input(1, i))});
    }
    return distance_outside({static_cast<double>(point[0]), static_cast<double>(point[1])}, controls) / ulp(largest);
  }
};

}  // namespace bezierbench::guarantees
