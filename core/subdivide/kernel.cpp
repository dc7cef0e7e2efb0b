// SPDX-License-Identifier: MIT
#include "core/subdivide/kernel.hpp"

#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/kernel_tables.hpp"
#include "core/subdivide/roster.hpp"

namespace bezierbench {
namespace {

template <SplitMethod M>
constexpr const SplitBound* bound_of() {
  if constexpr (requires { M::bound; })
    return &M::bound;
  else
    return nullptr;
}

template <class Scalar, int Dimension>
void write(const Curve<Form::bernstein, Scalar, Dimension>& half, Scalar* numbers) {
  for (int i = 0; i <= half.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) *numbers++ = half(axis, i);
}

template <class Scalar, int Dimension>
void write(const Curve<Form::rational, Scalar, Dimension>& half, Scalar* numbers) {
  for (int i = 0; i <= half.degree(); ++i) {
    for (int axis = 0; axis < Dimension; ++axis) *numbers++ = half.points(axis, i);
    *numbers++ = half.weights[i];
  }
}

struct MakeKernel {
  template <SplitMethod M, int Dimension>
  static constexpr SplitKernel of() {
    return {&M::info, &M::promises, bound_of<M>(), Dimension,
            [](const CurveView<double>& view, double t, double* left, double* right) {
              const auto halves = M::split(instantiate::load<M::info.form, Dimension>(view), t);
              write(halves.left, left);
              write(halves.right, right);
            }};
  }
};

}  // namespace

std::span<const SplitKernel> split_kernels(int dimension) {
  return kernels_of<SplitKernel, MakeKernel>(SplitMethods{}, dimension);
}

}  // namespace bezierbench
