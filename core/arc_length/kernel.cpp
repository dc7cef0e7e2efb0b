// SPDX-License-Identifier: MIT
#include "core/arc_length/kernel.hpp"

#include <cmath>

#include "core/arc_length/part.hpp"
#include "core/arc_length/roster.hpp"
#include "core/arc_length/scale.hpp"
#include "core/derivative/hodograph.hpp"
#include "core/evaluate/kernel_of.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

template <ArcLengthMethod M, int Dimension>
ArcLength measure(const CurveView<double>& view, double from, double to, double tolerance) {
  auto curve = instantiate::load<Form::bernstein, Dimension>(view);
  int exponent = normalise(curve);  // or else differences may overflow
  const auto whole = hodograph(curve, 1);
  auto h = whole;
  restrict_to(h, from, to);
  const double rounding = std::ldexp(rounding_of_part(whole, h, from, to), exponent);
  exponent += normalise(h);
  if (is_zero(h) || from == to) return {.length = 0, .error_estimate = 0, .evaluations = 0, .converged = true};
  ArcLength result = M::measure(h, tolerance);
  result.length = std::ldexp(result.length * (to - from), exponent);
  result.error_estimate = std::ldexp(result.error_estimate * (to - from), exponent) + rounding;
  result.converged = result.converged && result.error_estimate <= tolerance * result.length;
  return result;
}

struct Entry {
  template <ArcLengthMethod M, int Dimension>
  static constexpr ArcLengthKernel of() {
    return {&M::info, Dimension, measure<M, Dimension>};
  }
};

}  // namespace

std::span<const ArcLengthKernel> arc_length_kernels(int dimension) {
  return kernels_of<ArcLengthKernel, Entry>(ArcLengthMethods{}, dimension);
}

std::span<const MethodInfo* const> arc_length_infos() { return infos_of(ArcLengthMethods{}); }

}  // namespace bezierbench
