// SPDX-License-Identifier: MIT
// Control points as Open CASCADE takes them: one array, counted from 1, of points in the plane or in space.
#pragma once

#include <opencascade/TColgp_Array1OfPnt.hxx>
#include <opencascade/TColgp_Array1OfPnt2d.hxx>

#include "core/curve.hpp"

namespace bezierbench::peers {

/// `curve(axis, i)` and `degree` of a curve in Bernstein form with two axes.
template <class Points>
TColgp_Array1OfPnt2d occt_poles_2d(const Points& curve, int degree) {
  TColgp_Array1OfPnt2d poles(1, degree + 1);
  for (int i = 0; i <= degree; ++i) poles(i + 1) = gp_Pnt2d(curve(0, i), curve(1, i));
  return poles;
}

/// Likewise with three.
template <class Points>
TColgp_Array1OfPnt occt_poles_3d(const Points& curve, int degree) {
  TColgp_Array1OfPnt poles(1, degree + 1);
  for (int i = 0; i <= degree; ++i) poles(i + 1) = gp_Pnt(curve(0, i), curve(1, i), curve(2, i));
  return poles;
}

}  // namespace bezierbench::peers
