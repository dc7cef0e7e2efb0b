// SPDX-License-Identifier: MIT
#include "core/fit/kernel.hpp"

#include "core/fit/piecewise.hpp"
#include "core/fit/roster.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

struct MakeKernel {
  template <FittingMethod M, int Dimension>
  static constexpr FittingKernel of() {
    return {&M::info, Dimension, [](std::span<const double> points, double tolerance, const FitEnds& ends) {
              return Piecewise<M, Dimension>(points, tolerance, ends).fit();
            }};
  }
};

}  // namespace

std::span<const FittingKernel> fitting_kernels(int dimension) {
  return kernels_of<FittingKernel, MakeKernel>(FittingMethods{}, dimension);
}

}  // namespace bezierbench
