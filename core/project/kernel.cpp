// SPDX-License-Identifier: MIT
#include "core/project/kernel.hpp"

#include <array>

#include "core/evaluate/kernel_of.hpp"
#include "core/project/roster.hpp"

namespace bezierbench {
namespace {

template <ProjectionMethod M, int Dimension>
constexpr ProjectionKernel kernel() {
  return {&M::info, Dimension, [](const CurveView<double>& view, std::span<const double> coordinates) {
            Point<double, Dimension> point;
            for (int axis = 0; axis < Dimension; ++axis) point[axis] = coordinates[static_cast<std::size_t>(axis)];
            return M::project(instantiate::load<M::info.form, Dimension>(view), point);
          }};
}

template <int Dimension, class... Ms>
std::span<const ProjectionKernel> table_of(TypeList<Ms...>) {
  static constexpr std::array table{kernel<Ms, Dimension>()...};
  return table;
}

template <class... Ms>
std::span<const MethodInfo* const> infos_of(TypeList<Ms...>) {
  static constexpr std::array<const MethodInfo*, sizeof...(Ms)> infos{&Ms::info...};
  return infos;
}

}  // namespace

std::span<const ProjectionKernel> projection_kernels(int dimension) {
  switch (dimension) {
    case 1: return table_of<1>(ProjectionMethods{});
    case 2: return table_of<2>(ProjectionMethods{});
    case 3: return table_of<3>(ProjectionMethods{});
    default: return {};
  }
}

std::span<const MethodInfo* const> projection_infos() { return infos_of(ProjectionMethods{}); }

}  // namespace bezierbench
