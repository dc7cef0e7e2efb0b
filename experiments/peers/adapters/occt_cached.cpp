// SPDX-License-Identifier: MIT
// Open CASCADE: the adaptor through which its algorithms see a curve. It keeps a span in power form.
//
// Computes: Taylor coefficients at the beginning of the span, here t = 0, on first use (so they count for one-shot
// times), then Horner's scheme. Fails: the power form loses digits as the degree grows; degree 25 is the largest.
#include <opencascade/Geom2dAdaptor_Curve.hxx>
#include <opencascade/Geom2d_BezierCurve.hxx>
#include <opencascade/GeomAdaptor_Curve.hxx>
#include <opencascade/Geom_BezierCurve.hxx>

#include "experiments/peers/adapter.hpp"
#include "experiments/peers/adapters/occt_poles.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

struct OcctCached {
  static constexpr MethodInfo info{.id = "peer_occt_cached",
                                   .label = "Open CASCADE adaptor",
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .max_degree = 25,
                                   .bit_stable = false,
                                   .flops = "that of the library, O(n)",
                                   .prepare_exponent = 2,
                                   .citation = "Open CASCADE, Geom2dAdaptor_Curve::D0"};

  static Geom2dAdaptor_Curve prepare(const Curve<Form::bernstein, double, 2>& curve) {
    return Geom2dAdaptor_Curve(new Geom2d_BezierCurve(occt_poles_2d(curve, curve.degree())));
  }
  static GeomAdaptor_Curve prepare(const Curve<Form::bernstein, double, 3>& curve) {
    return GeomAdaptor_Curve(new Geom_BezierCurve(occt_poles_3d(curve, curve.degree())));
  }

  static Point<double, 2> evaluate(const Geom2dAdaptor_Curve& curve, double t) {
    gp_Pnt2d point;
    curve.D0(t, point);
    return {point.X(), point.Y()};
  }
  static Point<double, 3> evaluate(const GeomAdaptor_Curve& curve, double t) {
    gp_Pnt point;
    curve.D0(t, point);
    return {point.X(), point.Y(), point.Z()};
  }
};

}  // namespace

std::span<const Kernel<double>> peer_occt_cached(int dimension) { return kernels_of<OcctCached>(dimension); }

}  // namespace bezierbench::peers
