// SPDX-License-Identifier: MIT
// SISL (SINTEF): s1957, the closest point of a B-spline, here of one span.
//
// Computes: Newton's method from a first guess; its manual says that it is fast and works well in clear cut cases, and
// does not guarantee the right solution.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "experiments/peers/adapters/sisl_curve.hpp"
#include "experiments/peers/companion_adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

constexpr auto info =
    companion_info("peer_sisl_closest", "SISL, closest point of a B-spline", Problem::projection, "SISL, s1957");

FootPoint project(const CurveView<double>& curve, std::span<const double> point) {
  const auto b_spline = sisl_curve(curve);
  std::vector<double> target(point.begin(), point.end());
  double largest = 0;
  for (const double x : curve.coefficients) largest = std::max(largest, std::abs(x));
  const double resolution = 0x1p-40 * largest;
  constexpr double unused = 0;
  int status = 0;
  double t = 0;
  double distance = 0;
  s1957(b_spline.get(), target.data(), curve.dimension, unused, resolution, &t, &distance, &status);
  if (status < 0) t = distance = std::numeric_limits<double>::quiet_NaN();
  return {.t = t, .distance = distance};
}

}  // namespace

std::span<const ProjectionKernel> peer_sisl_closest(int dimension) {
  static constexpr std::array kernels{ProjectionKernel{&info, 2, project}, ProjectionKernel{&info, 3, project}};
  return in_dimension(kernels, dimension);
}

}  // namespace bezierbench::peers
