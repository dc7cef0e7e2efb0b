// SPDX-License-Identifier: MIT
// 2geom (Inkscape): the length of a D2<SBasis>.
//
// Computes: GSL's adaptive Gauss-Kronrod rule of 21 points (qag) on the speed, the root of an SBasis; its tolerance is
// relative. GSL's estimate of the error is not handed on (version 1.2.2 leaves its argument alone), so nothing is
// promised.
#include <2geom/sbasis-geometric.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <array>
#include <mutex>

#include "experiments/peers/adapters/2geom_curve.hpp"
#include "experiments/peers/companion_adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

constexpr auto info = companion_info("peer_2geom_length", "2geom, length of an SBasis", Problem::arc_length,
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
  static constexpr std::array kernels{ArcLengthKernel{&info, 2, measure}};
  return in_dimension(kernels, dimension);
}

}  // namespace bezierbench::peers
