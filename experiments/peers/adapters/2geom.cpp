// SPDX-License-Identifier: MIT
// A Bezier curve as 2geom takes it: one Bernstein polynomial per axis of the plane.
#include <2geom/bezier.h>
#include <2geom/d2.h>
#include <2geom/nearest-time.h>
#include <2geom/sbasis-geometric.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <array>
#include <mutex>

#include "core/curve.hpp"
#include "experiments/peers/adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

Geom::D2<Geom::Bezier> two_geom_curve(const CurveView<double>& curve) {
  const auto axis = [&](int a) {
    Geom::Bezier bezier(Geom::Bezier::Order(static_cast<unsigned>(curve.degree)));
    for (int i = 0; i <= curve.degree; ++i) bezier[static_cast<unsigned>(i)] = curve(a, i);
    return bezier;
  };
  return {axis(0), axis(1)};
}

// 2geom (Inkscape): D2<Bezier>, one Bernstein polynomial per axis of the plane.
//
// Computes: nested multiplication with running powers and binomials, axis by axis.
// Fails: C(n,i) (n-i+1) overflows past degree 1020.

struct TwoGeom {
  static constexpr MethodInfo info{.id = "peer_2geom",
                                   .label = "2geom D2<Bezier>",
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .max_degree = 1020,
                                   .bit_stable = false,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "7dn, dn of them divisions",
                                   .citation = "2geom, D2<Bezier>::valueAt"};

  using Prepared = Geom::D2<Geom::Bezier>;

  static Prepared prepare(const Curve<Form::bernstein, double, 2>& curve) {
    const auto count = 2 * static_cast<std::size_t>(curve.degree() + 1);
    return two_geom_curve({Form::bernstein, 2, curve.degree(), std::span(curve.data(), count)});
  }

  static Point<double, 2> evaluate(const Prepared& curve, double t) {
    const Geom::Point point = curve.valueAt(t);
    return {point[Geom::X], point[Geom::Y]};
  }
};

}  // namespace

std::span<const Kernel<double>> peer_2geom(int dimension) { return kernels_of<TwoGeom>(dimension); }

// 2geom (Inkscape): the length of a D2<SBasis>.
//
// Computes: GSL's adaptive Gauss-Kronrod rule of 21 points (qag) on the speed, the root of an SBasis; its tolerance is
// relative. GSL's estimate of the error is not handed on (version 1.2.2 leaves its argument alone), so nothing is
// promised.

namespace {

constexpr auto length_info = companion_info("peer_2geom_length", "2geom, length of an SBasis", Problem::arc_length,
                                            "2geom, length_integrating(D2<SBasis>)");

ArcLength measure(const CurveView<double>& curve, double from, double to, double tolerance) {
  static std::once_flag once;
  std::call_once(once, gsl_set_error_handler_off);  // or else it would end the program
  auto bezier = two_geom_curve(curve);
  if (from > 0 || to < 1) bezier = Geom::portion(bezier, from, to);
  constexpr double min_tolerance = 50 * 0x1p-52;  // GSL refuses smaller ones, and the length would be 0
  ArcLength result;
  double untouched = 0;
  Geom::length_integrating(bezier.toSBasis(), result.length, untouched, std::max(tolerance, min_tolerance));
  return result;
}

}  // namespace

std::span<const ArcLengthKernel> peer_2geom_length(int dimension) {
  static constexpr std::array kernels{ArcLengthKernel{&length_info, 2, measure}};
  return in_dimension(kernels, dimension);
}

// 2geom (Inkscape): the parameter at which a D2<Bezier> is nearest to a point.
//
// Computes: the roots of (C - P).C' as a Bernstein polynomial, by subdivision, and compares them with the ends.

namespace {

constexpr auto nearest_info = companion_info("peer_2geom_nearest", "2geom, nearest time", Problem::projection,
                                             "2geom, nearest_time(Point, D2<Bezier>)");

FootPoint project(const CurveView<double>& curve, std::span<const double> point) {
  const auto bezier = two_geom_curve(curve);
  const Geom::Point target(point[0], point[1]);
  const double t = Geom::nearest_time(target, bezier);
  return {.t = t, .distance = Geom::distance(bezier.valueAt(t), target)};
}

}  // namespace

std::span<const ProjectionKernel> peer_2geom_nearest(int dimension) {
  static constexpr std::array kernels{ProjectionKernel{&nearest_info, 2, project}};
  return in_dimension(kernels, dimension);
}

}  // namespace bezierbench::peers
