// SPDX-License-Identifier: MIT
#include "core/bounds/kernel.hpp"

#include "core/bounds/roster.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

struct MakeKernel {
  template <BoundsMethod M, int Dimension>
  static constexpr BoundsKernel of() {
    return {&M::info, &M::promises, Dimension, [](const CurveView<double>& curve, double* sides) {
              Curve<M::info.form, double, 1> coordinates(curve.degree);
              for (int axis = 0; axis < Dimension; ++axis) {
                for (int i = 0; i <= curve.degree; ++i) {
                  if constexpr (M::info.form == Form::rational) {
                    coordinates.points(0, i) = curve(axis, i);
                    coordinates.weights[i] = curve.weights[static_cast<std::size_t>(i)];
                  } else {
                    coordinates(0, i) = curve(axis, i);
                  }
                }
                const Range range = M::range(coordinates);
                *sides++ = range.low;
                *sides++ = range.high;
              }
            }};
  }
};

}  // namespace

std::span<const BoundsKernel> bounds_kernels(int dimension) {
  return kernels_of<BoundsKernel, MakeKernel>(BoundsMethods{}, dimension);
}

}  // namespace bezierbench
