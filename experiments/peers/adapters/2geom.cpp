// SPDX-License-Identifier: MIT
// 2geom (Inkscape): D2<Bezier>, one Bernstein polynomial per axis of the plane.
//
// Computes: nested multiplication with running powers and binomials, axis by axis.
// Fails: C(n,i) (n-i+1) overflows past degree 1020.
#include "experiments/peers/adapter.hpp"
#include "experiments/peers/adapters/2geom_curve.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

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

}  // namespace bezierbench::peers
