// SPDX-License-Identifier: MIT
// Open CASCADE: BSplCLib::D0 on the poles of a Bezier curve, which is what Geom_BezierCurve and Geom2d_BezierCurve
// call.
//
// Computes: de Boor's algorithm on one span, which is de Casteljau's.
// Fails: degree 25 is the largest.
#include <opencascade/BSplCLib.hxx>

#include "experiments/peers/adapter.hpp"
#include "experiments/peers/adapters/occt_poles.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

struct OcctBsplclib {
  static constexpr MethodInfo info{.id = "peer_occt_bsplclib",
                                   .label = "Open CASCADE BSplCLib",
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .max_degree = 25,
                                   .bit_stable = false,
                                   .flops = "that of the library, O(n^2)",
                                   .cost_exponent = 2,
                                   .citation = "Open CASCADE, BSplCLib::D0"};

  static TColgp_Array1OfPnt2d prepare(const Curve<Form::bernstein, double, 2>& curve) {
    return occt_poles_2d(curve, curve.degree());
  }
  static TColgp_Array1OfPnt prepare(const Curve<Form::bernstein, double, 3>& curve) {
    return occt_poles_3d(curve, curve.degree());
  }

  static Point<double, 2> evaluate(const TColgp_Array1OfPnt2d& poles, double t) {
    gp_Pnt2d point;
    BSplCLib::D0(t, poles, BSplCLib::NoWeights(), point);
    return {point.X(), point.Y()};
  }
  static Point<double, 3> evaluate(const TColgp_Array1OfPnt& poles, double t) {
    gp_Pnt point;
    BSplCLib::D0(t, poles, BSplCLib::NoWeights(), point);
    return {point.X(), point.Y(), point.Z()};
  }
};

}  // namespace

std::span<const Kernel<double>> peer_occt_bsplclib(int dimension) { return kernels_of<OcctBsplclib>(dimension); }

}  // namespace bezierbench::peers
