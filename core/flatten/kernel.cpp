// SPDX-License-Identifier: MIT
#include "core/flatten/kernel.hpp"

#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/flatten/roster.hpp"
#include "core/flatten/scaled.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

/// Degrees that the method does not take have no code of their own.
template <FlattenMethod M, int Fixed, int Dimension>
void flatten_degree(const CurveView<double>& view, double tolerance, Flattening& chords) {
  constexpr int degree = Fixed == dynamic || M::info.template supports<double>(Fixed) ? Fixed : dynamic;
  const auto copy_points = [&](auto& points) {
    for (int i = 0; i <= view.degree; ++i)
      for (int axis = 0; axis < Dimension; ++axis) points(axis, i) = view(axis, i);
  };
  Curve<M::info.form, double, Dimension, degree> curve(view.degree);
  if constexpr (M::info.form == Form::rational) {
    copy_points(curve.points);
    for (int i = 0; i <= view.degree; ++i) curve.weights[i] = view.weights[static_cast<std::size_t>(i)];
  } else {
    copy_points(curve);
  }
  flatten_scaled<M>(curve, tolerance, chords);
}

template <class M>
constexpr bool keeps_tolerance() {
  if constexpr (requires { M::keeps_tolerance; })
    return M::keeps_tolerance;
  else
    return false;
}

template <class M>
constexpr bool reverses() {
  if constexpr (requires { M::reverses; })
    return M::reverses;
  else
    return false;
}

struct MakeKernel {
  template <FlattenMethod M, int Dimension>
  static constexpr FlattenKernel of() {
    return {&M::info, Dimension, keeps_tolerance<M>(), reverses<M>(),
            [](const CurveView<double>& view, double tolerance, Flattening& chords) {
              chords.clear();
              switch (view.degree) {
                case 2: return flatten_degree<M, 2, Dimension>(view, tolerance, chords);
                case 3: return flatten_degree<M, 3, Dimension>(view, tolerance, chords);
                default: return flatten_degree<M, dynamic, Dimension>(view, tolerance, chords);
              }
            }};
  }
};

}  // namespace

std::span<const FlattenKernel> flatten_kernels(int dimension) {
  return kernels_of<FlattenKernel, MakeKernel>(FlattenMethods{}, dimension);
}

}  // namespace bezierbench
