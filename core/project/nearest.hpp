// SPDX-License-Identifier: MIT
// The nearest of some parameters: the last step of every projector that finds candidates first.
#pragma once

#include <limits>
#include <vector>

#include "core/project/offset_curve.hpp"
#include "core/project/projection.hpp"

namespace bezierbench {

/// Compares the distances at these parameters of [0, 1] and at both ends of the curve; of equally near ones the
/// smallest parameter counts, and a parameter that occurs twice counts once.
template <int Dimension>
FootPoint nearest(const OffsetCurve<Dimension>& curve, std::vector<double> candidates) {
  candidates.insert(candidates.end(), {0.0, 1.0});
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  FootPoint foot{0, std::numeric_limits<double>::infinity(), static_cast<int>(candidates.size()), true};
  for (const double t : candidates)
    if (const double distance = curve.distance(t); distance < foot.distance) {
      foot.t = t;
      foot.distance = distance;
    }
  return foot;
}

}  // namespace bezierbench
