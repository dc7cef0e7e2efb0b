// SPDX-License-Identifier: MIT
#include "core/derivative/kernel.hpp"

#include "core/derivative/roster.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

template <DerivativeMethod M>
constexpr const DerivativeBound* bound_of() {
  if constexpr (requires { M::bound; })
    return &M::bound;
  else if constexpr (requires { M::polynomial_bound; })
    return M::info.promise.empty() ? nullptr : &M::polynomial_bound;
  else
    return nullptr;
}

struct MakeKernel {
  template <DerivativeMethod M, int Dimension>
  static constexpr DerivativeKernel of() {
    return {&M::info, bound_of<M>(), Dimension,
            [](const CurveView<double>& view, int order, double t, double* coordinates) {
              const auto prepared = M::prepare(instantiate::load<M::info.form, Dimension>(view), order);
              const Point<double, Dimension> derivative = M::evaluate(prepared, t);
              for (int axis = 0; axis < Dimension; ++axis) coordinates[axis] = derivative[axis];
            }};
  }
};

}  // namespace

std::span<const DerivativeKernel> derivative_kernels(int dimension) {
  return kernels_of<DerivativeKernel, MakeKernel>(DerivativeMethods{}, dimension);
}

}  // namespace bezierbench
