// SPDX-License-Identifier: MIT
// Open CASCADE: the length of its adaptor of a Bezier curve.
//
// Computes: a Gauss-Legendre rule of as many points as suit the degree on 2, 4, 8, ... equal parts until two sums
// differ by less than the tolerance, at most 2^13 parts. That tolerance is absolute: it is handed that share of the
// length that one rule over the whole gives, which costs one rule more. Whether it was reached is not handed on, so
// nothing is promised. Fails: degree 25 is the largest; the adaptor keeps the curve in power form, which loses digits
// as the degree grows.
#include <array>
#include <opencascade/GCPnts_AbscissaPoint.hxx>
#include <opencascade/Geom2dAdaptor_Curve.hxx>
#include <opencascade/Geom2d_BezierCurve.hxx>
#include <opencascade/GeomAdaptor_Curve.hxx>
#include <opencascade/Geom_BezierCurve.hxx>

#include "experiments/peers/adapters/occt_poles.hpp"
#include "experiments/peers/companion_adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

constexpr auto info = companion_info("peer_occt_length", "Open CASCADE, length of an adaptor", Problem::arc_length,
                                     "Open CASCADE, GCPnts_AbscissaPoint::Length", 25);

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
  static constexpr std::array kernels{ArcLengthKernel{&info, 2, measure_2d}, ArcLengthKernel{&info, 3, measure_3d}};
  return in_dimension(kernels, dimension);
}

}  // namespace bezierbench::peers
