// SPDX-License-Identifier: MIT
#include "core/grid/kernel.hpp"

#include <cassert>

#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/grid/roster.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

struct MakeKernel {
  template <GridMethod M, int Dimension>
  static constexpr GridKernel of() {
    return {&M::info, &M::bound, Dimension, [](const CurveView<double>& view, int steps, double* coordinates) {
              assert(is_grid(steps));
              const auto prepared = M::prepare(instantiate::load<M::info.form, Dimension>(view), steps);
              M::run(prepared, [coordinates](int k, const Point<double, Dimension>& point) {
                for (int axis = 0; axis < Dimension; ++axis) coordinates[k * Dimension + axis] = point[axis];
              });
            }};
  }
};

}  // namespace

std::span<const GridKernel> grid_kernels(int dimension) {
  return kernels_of<GridKernel, MakeKernel>(GridMethods{}, dimension);
}

}  // namespace bezierbench
