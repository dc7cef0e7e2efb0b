// SPDX-License-Identifier: MIT
// A Bezier curve as 2geom takes it: one Bernstein polynomial per axis of the plane.
#pragma once

#include <2geom/bezier.h>
#include <2geom/d2.h>

#include "core/curve.hpp"

namespace bezierbench::peers {

inline Geom::D2<Geom::Bezier> two_geom_curve(const CurveView<double>& curve) {
  const auto axis = [&](int a) {
    Geom::Bezier bezier(Geom::Bezier::Order(static_cast<unsigned>(curve.degree)));
    for (int i = 0; i <= curve.degree; ++i) bezier[static_cast<unsigned>(i)] = curve(a, i);
    return bezier;
  };
  return {axis(0), axis(1)};
}

}  // namespace bezierbench::peers
