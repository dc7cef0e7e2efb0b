// SPDX-License-Identifier: MIT
// Equally spaced samples of a curve, and the nearest of them: the first step of every search by scanning.
#pragma once

#include <limits>

#include "core/project/rational_offset.hpp"

namespace bezierbench {

/// |C(t) - P|^2 / m^2 in plain floating point, which the searches compare.
template <int Dimension>
double squared_distance(const RationalOffset<Dimension>& curve, double t) {
  const auto offset = curve.at(t);
  return dot<Dimension>(offset, offset);
}
template <int Dimension>
double squared_distance(const OffsetCurve<Dimension>& curve, double t) {
  const auto offset = point_at<Dimension>(curve.offsets(), t);
  return dot<Dimension>(offset, offset);
}

/// The parameter of the nearest of the samples from + i (to - from) / slices, i = 0, ..., slices; of equally near ones
/// the first.
template <class Offset>
double nearest_sample(const Offset& curve, double from, double to, int slices) {
  double best = from;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= slices; ++i) {
    const double t = i == slices ? to : from + (to - from) * (static_cast<double>(i) / slices);
    if (const double squared = squared_distance(curve, t); squared < least) {
      least = squared;
      best = t;
    }
  }
  return best;
}

}  // namespace bezierbench
