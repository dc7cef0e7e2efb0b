// SPDX-License-Identifier: MIT
// The tables of all families, of the target that the including translation unit is compiled for.
#pragma once

#include <hwy/highway.h>

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

template <class Target, class S, class... Family>
inline constexpr const FamilyTable<S>* families[sizeof...(Family)] = {&FamilyOf<Target, Family, S>::table...};

template <class Target, class S, class... Family>
constexpr TargetTable<S> table_of(TypeList<Family...> /*families*/) {
  return {families<Target, S, Family...>, divide<S>, &GroupsOf<Target, S>::table};
}

}  // namespace HWY_NAMESPACE

template <class Target, class Scalar>
constinit const TargetTable<Scalar> TableOf<Target, Scalar>::table =
    HWY_NAMESPACE::table_of<Target, Scalar>(Families());

}  // namespace bezierbench::batch
