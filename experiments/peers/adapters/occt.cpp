// SPDX-License-Identifier: MIT
// Control points as Open CASCADE takes them: one array, counted from 1, of points in the plane or in space.
#include <array>
#include <opencascade/BSplCLib.hxx>
#include <opencascade/GCPnts_AbscissaPoint.hxx>
#include <opencascade/Geom2dAdaptor_Curve.hxx>
#include <opencascade/Geom2d_BezierCurve.hxx>
#include <opencascade/GeomAdaptor_Curve.hxx>
#include <opencascade/Geom_BezierCurve.hxx>
#include <opencascade/TColgp_Array1OfPnt.hxx>
#include <opencascade/TColgp_Array1OfPnt2d.hxx>

#include "core/curve.hpp"
#include "experiments/peers/adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

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

// Open CASCADE: BSplCLib::D0 on the poles of a Bezier curve, which is what Geom_BezierCurve and Geom2d_BezierCurve
// call.
//
// Computes: de Boor's algorithm on one span, which is de Casteljau's.
// Fails: degree 25 is the largest.

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

// Open CASCADE: the adaptor through which its algorithms see a curve. It keeps a span in power form.
//
// Computes: Taylor coefficients at the beginning of the span, here t = 0, on first use (so they count for one-shot
// times), then Horner's scheme. Fails: the power form loses digits as the degree grows; degree 25 is the largest.

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

// Open CASCADE: the length of its adaptor of a Bezier curve.
//
// Computes: a Gauss-Legendre rule of as many points as suit the degree on 2, 4, 8, ... equal parts until two sums
// differ by less than the tolerance, at most 2^13 parts. That tolerance is absolute: it is handed that share of the
// length that one rule over the whole gives, which costs one rule more. Whether it was reached is not handed on, so
// nothing is promised. Fails: degree 25 is the largest; the adaptor keeps the curve in power form, which loses digits
// as the degree grows.

namespace {

constexpr auto length_info = companion_info("peer_occt_length", "Open CASCADE, length of an adaptor",
                                            Problem::arc_length, "Open CASCADE, GCPnts_AbscissaPoint::Length", 25);

template <class Adaptor>
ArcLength length_of(const Adaptor& curve, double from, double to, double tolerance) {
  ArcLength result;
  result.length = GCPnts_AbscissaPoint::Length(curve, from, to);
  result.length = GCPnts_AbscissaPoint::Length(curve, from, to, tolerance * result.length);
  return result;
}

ArcLength measure_2d(const CurveView<double>& curve, double from, double to, double tolerance) {
  const Geom2dAdaptor_Curve adaptor(new Geom2d_BezierCurve(occt_poles_2d(curve, curve.degree)));
  return length_of(adaptor, from, to, tolerance);
}

ArcLength measure_3d(const CurveView<double>& curve, double from, double to, double tolerance) {
  const GeomAdaptor_Curve adaptor(new Geom_BezierCurve(occt_poles_3d(curve, curve.degree)));
  return length_of(adaptor, from, to, tolerance);
}

}  // namespace

std::span<const ArcLengthKernel> peer_occt_length(int dimension) {
  static constexpr std::array kernels{ArcLengthKernel{&length_info, 2, measure_2d},
                                      ArcLengthKernel{&length_info, 3, measure_3d}};
  return in_dimension(kernels, dimension);
}

}  // namespace bezierbench::peers
