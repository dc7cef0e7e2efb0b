// SPDX-License-Identifier: MIT
// The tables of all units, of the target that the including translation unit is compiled for.
#pragma once

#include <hwy/highway.h>

#include <utility>

#include "core/batch/roster.hpp"
#include "core/batch/targets.hpp"

namespace bezierbench::batch {
namespace HWY_NAMESPACE {

template <class S>
void divide(const S* homogeneous, int dimension, std::size_t count, S* points, std::size_t stride) {
  const S* weights = homogeneous + static_cast<std::size_t>(dimension) * count;
  for (int axis = 0; axis < dimension; ++axis, homogeneous += count, points += stride)
    for (std::size_t k = 0; k < count; ++k) points[k] = homogeneous[k] / weights[k];
}

template <class Target, class S, int... Unit>
inline constexpr const TargetKernels<S>* const* units_of[sizeof...(Unit)] = {&UnitOf<Target, Unit, S>::table...};

template <class Target, class S, int... Unit>
constexpr TargetTable<S> table_of(std::integer_sequence<int, Unit...> /*units*/) {
  return {units_of<Target, S, Unit...>, divide<S>, &GroupsOf<Target, S>::table};
}

}  // namespace HWY_NAMESPACE

template <class Target, class Scalar>
constinit const TargetTable<Scalar> TableOf<Target, Scalar>::table =
    HWY_NAMESPACE::table_of<Target, Scalar>(std::make_integer_sequence<int, units>());

}  // namespace bezierbench::batch
