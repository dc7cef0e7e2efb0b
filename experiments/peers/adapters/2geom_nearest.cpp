// SPDX-License-Identifier: MIT
// 2geom (Inkscape): the parameter at which a D2<Bezier> is nearest to a point.
//
// Computes: the roots of (C - P).C' as a Bernstein polynomial, by subdivision, and compares them with the ends.
#include <2geom/nearest-time.h>

#include <array>

#include "experiments/peers/adapters/2geom_curve.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

constexpr MethodInfo info{.id = "peer_2geom_nearest",
                          .label = "2geom, nearest time",
                          .problem = Problem::projection,
                          .form = Form::bernstein,
                          .min_degree = 1,
                          .max_degree = 100,
                          .bit_stable = false,
                          .flops = "that of the library",
                          .citation = "2geom, nearest_time(Point, D2<Bezier>)"};

FootPoint project(const CurveView<double>& curve, std::span<const double> point) {
  const auto bezier = two_geom_curve(curve);
  const Geom::Point target(point[0], point[1]);
  const double t = Geom::nearest_time(target, bezier);
  return {.t = t, .distance = Geom::distance(bezier.valueAt(t), target)};
}

}  // namespace

std::span<const ProjectionKernel> peer_2geom_nearest(int dimension) {
  static constexpr std::array kernels{ProjectionKernel{&info, 2, project}};
  return dimension == 2 ? std::span<const ProjectionKernel>(kernels) : std::span<const ProjectionKernel>();
}

}  // namespace bezierbench::peers
