// SPDX-License-Identifier: MIT
#include "core/project/kernel.hpp"

#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/kernel_tables.hpp"
#include "core/project/roster.hpp"

namespace bezierbench {
namespace {

struct MakeKernel {
  template <ProjectionMethod M, int Dimension>
  static constexpr ProjectionKernel of() {
    ProjectionKernel kernel{&M::info, Dimension,
                            [](const CurveView<double>& view, std::span<const double> coordinates) {
                              Point<double, Dimension> point;
                              for (int axis = 0; axis < Dimension; ++axis)
                                point[axis] = coordinates[static_cast<std::size_t>(axis)];
                              return M::project(instantiate::load<M::info.form, Dimension>(view), point);
                            }};
    if constexpr (requires { M::residual_bound; }) kernel.residual_bound = M::residual_bound;
    return kernel;
  }
};

}  // namespace

std::span<const ProjectionKernel> projection_kernels(int dimension) {
  return kernels_of<ProjectionKernel, MakeKernel>(ProjectionMethods{}, dimension);
}

}  // namespace bezierbench
