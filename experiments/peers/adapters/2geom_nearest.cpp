// SPDX-License-Identifier: MIT
// 2geom (Inkscape): the parameter at which a D2<Bezier> is nearest to a point.
//
// Computes: the roots of (C - P).C' as a Bernstein polynomial, by subdivision, and compares them with the ends.
#include <2geom/nearest-time.h>

#include <array>

#include "experiments/peers/adapters/2geom_curve.hpp"
#include "experiments/peers/companion_adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

constexpr auto info = companion_info("peer_2geom_nearest", "2geom, nearest time", Problem::projection,
                                     "2geom, nearest_time(Point, D2<Bezier>)");

FootPoint project(const CurveView<double>& curve, std::span<const double> point) {
  const auto bezier = two_geom_curve(curve);
  const Geom::Point target(point[0], point[1]);
  const double t = Geom::nearest_time(target, bezier);
  return {.t = t, .distance = Geom::distance(bezier.valueAt(t), target)};
}

}  // namespace

std::span<const ProjectionKernel> peer_2geom_nearest(int dimension) {
  static constexpr std::array kernels{ProjectionKernel{&info, 2, project}};
  return in_dimension(kernels, dimension);
}

}  // namespace bezierbench::peers
