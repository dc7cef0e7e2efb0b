// SPDX-License-Identifier: MIT
#include "core/arc_length/inverse/kernel.hpp"

#include <cmath>

#include "core/arc_length/inverse/roster.hpp"
#include "core/arc_length/scale.hpp"
#include "core/derivative/hodograph.hpp"
#include "core/evaluate/kernel_of.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

template <InverseArcLengthMethod M, int Dimension>
InverseArcLength solve(const CurveView<double>& view, double target, double tolerance) {
  auto curve = instantiate::load<Form::bernstein, Dimension>(view);
  int exponent = normalise(curve);  // or else differences may overflow
  auto h = hodograph(curve, 1);
  exponent += normalise(h);
  if (is_zero(h)) return {.t = 0, .error_estimate = std::abs(target), .converged = target == 0};
  InverseArcLength result = M::solve(h, std::ldexp(target, -exponent), tolerance);
  result.error_estimate = std::ldexp(result.error_estimate, exponent);
  return result;
}

struct Entry {
  template <InverseArcLengthMethod M, int Dimension>
  static constexpr InverseArcLengthKernel of() {
    return {&M::info, Dimension, solve<M, Dimension>};
  }
};

}  // namespace

std::span<const InverseArcLengthKernel> inverse_arc_length_kernels(int dimension) {
  return kernels_of<InverseArcLengthKernel, Entry>(InverseArcLengthMethods{}, dimension);
}

std::span<const MethodInfo* const> inverse_arc_length_infos() { return infos_of(InverseArcLengthMethods{}); }

}  // namespace bezierbench
