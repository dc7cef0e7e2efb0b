// SPDX-License-Identifier: MIT
#include "core/arc_length/kernel.hpp"

#include <algorithm>
#include <cmath>

#include "core/arc_length/part.hpp"
#include "core/arc_length/roster.hpp"
#include "core/arc_length/scale.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/kernel_tables.hpp"
#include "core/powers.hpp"

namespace bezierbench {
namespace {

/// The answer for the whole task. `part` is the result over [0, 1] in units of 2^exponent. The answer is that times the
/// scaled width of the parameters; its error includes the roundings of cutting the curve, and the rounding of a length
/// that is not a double. It has converged if all of this is within the tolerance.
template <class Hodograph>
ArcLength unscaled(ArcLength part, const ScaledHodograph<Hodograph>& scaled, double width, double rounding,
                   double tolerance) {
  const double length = part.length * width;
  part.length = times_power_of_two(length, scaled.exponent);
  const double lost = std::abs(scaled.in_units(part.length) - length);
  part.error_estimate = scaled.unscaled_error(part.error_estimate * width + rounding + lost);
  part.converged = part.converged && std::isfinite(part.length) &&
                   scaled.in_units(part.error_estimate) <= tolerance * scaled.in_units(part.length);
  return part;
}

template <ArcLengthMethod M, int Dimension>
ArcLength measure(const CurveView<double>& view, double from, double to, double tolerance) {
  auto scaled = scaled_hodograph(instantiate::load<M::info.form, Dimension>(view));
  if (is_zero(scaled.h) || from == to) return {.length = 0, .error_estimate = 0, .evaluations = 0, .converged = true};
  auto h = scaled.h;
  restrict_to(h, from, to);
  // The width is scaled, too: with a subnormal width, the products of the length and of its error underflow.
  const int width_exponent = binary_exponent(to - from);
  const double width = times_power_of_two(to - from, -width_exponent);
  const double rounding_of_whole = rounding_of_part(scaled.h, h, from, to, width_exponent);
  const int exponent = normalise(h);
  const double rounding = times_power_of_two(rounding_of_whole, -exponent);
  scaled.exponent += exponent + width_exponent;
  // A part that is 0 after cutting may have a length, below the roundings.
  const ArcLength part = is_zero(h) ? ArcLength{.error_estimate = 0} : M::measure(h, tolerance);
  return unscaled(part, scaled, width, rounding, tolerance);
}

struct MakeKernel {
  template <ArcLengthMethod M, int Dimension>
  static constexpr ArcLengthKernel of() {
    return {&M::info, Dimension, measure<M, Dimension>};
  }
};

}  // namespace

double whole_length(const CurveView<double>& curve) {
  constexpr double tolerance = 1e-15;
  const auto methods = arc_length_kernels(curve.dimension);
  return std::ranges::find_if(methods,
                              [&](const auto& method) {
                                return method.info->id == "gauss_legendre_adaptive" && method.info->form == curve.form;
                              })
      ->measure(curve, 0, 1, tolerance)
      .length;
}

std::span<const ArcLengthKernel> arc_length_kernels(int dimension) {
  return kernels_of<ArcLengthKernel, MakeKernel>(ArcLengthMethods{}, dimension);
}

}  // namespace bezierbench
