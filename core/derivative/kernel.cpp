// SPDX-License-Identifier: MIT
#include "core/derivative/kernel.hpp"

#include <array>

#include "core/derivative/roster.hpp"
#include "core/evaluate/kernel_of.hpp"

namespace bezierbench {
namespace {

template <DerivativeMethod M>
constexpr const DerivativeBound* bound_of() {
  if constexpr (requires { M::bound; })
    return &M::bound;
  else
    return nullptr;
}

template <DerivativeMethod M, int Dimension>
constexpr DerivativeKernel kernel() {
  return {&M::info, bound_of<M>(), Dimension,
          [](const CurveView<double>& view, int order, double t, double* coordinates) {
            const auto prepared = M::prepare(instantiate::load<M::info.form, Dimension>(view), order);
            const Point<double, Dimension> derivative = M::evaluate(prepared, t);
            for (int axis = 0; axis < Dimension; ++axis) coordinates[axis] = derivative[axis];
          }};
}

template <int Dimension, class... Ms>
std::span<const DerivativeKernel> table_of(TypeList<Ms...>) {
  static constexpr std::array table{kernel<Ms, Dimension>()...};
  return table;
}

template <class... Ms>
std::span<const MethodInfo* const> infos_of(TypeList<Ms...>) {
  static constexpr std::array<const MethodInfo*, sizeof...(Ms)> infos{&Ms::info...};
  return infos;
}

}  // namespace

std::span<const DerivativeKernel> derivative_kernels(int dimension) {
  switch (dimension) {
    case 1: return table_of<1>(DerivativeMethods{});
    case 2: return table_of<2>(DerivativeMethods{});
    case 3: return table_of<3>(DerivativeMethods{});
    default: return {};
  }
}

std::span<const MethodInfo* const> derivative_infos() { return infos_of(DerivativeMethods{}); }

}  // namespace bezierbench
