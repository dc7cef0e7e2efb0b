// SPDX-License-Identifier: MIT
#include "core/arc_length/inverse/kernel.hpp"

#include <cmath>

#include "core/arc_length/inverse/roster.hpp"
#include "core/arc_length/scale.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

template <InverseArcLengthMethod M, int Dimension>
InverseArcLength solve(const CurveView<double>& view, double target, double tolerance) {
  const auto scaled = scaled_hodograph(instantiate::load<M::info.form, Dimension>(view));
  if (is_zero(scaled.h)) return {.t = 0, .error_estimate = std::abs(target), .converged = target == 0};
  const double scaled_target = scaled.in_units(target);
  InverseArcLength result = M::solve(scaled.h, scaled_target, tolerance);
  // A target far below the size of the curve underflows.
  const double lost = std::abs(times_power_of_two(scaled_target, scaled.exponent) - target);
  result.error_estimate = scaled.unscaled_error(result.error_estimate) + lost;
  return result;
}

struct MakeKernel {
  template <InverseArcLengthMethod M, int Dimension>
  static constexpr InverseArcLengthKernel of() {
    return {&M::info, Dimension, solve<M, Dimension>};
  }
};

}  // namespace

std::span<const InverseArcLengthKernel> inverse_arc_length_kernels(int dimension) {
  return kernels_of<InverseArcLengthKernel, MakeKernel>(InverseArcLengthMethods{}, dimension);
}

}  // namespace bezierbench
