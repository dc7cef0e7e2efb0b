// SPDX-License-Identifier: MIT
// The table of the target that the including translation unit is compiled for.
#pragma once

#include "core/batch/peak_work.hpp"
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

/// Two multiply-adds of four cycles each start in a cycle, so that at least eight chains are needed; sixteen registers
/// hold twelve of them, or seven of both kinds.
template <class Target, class S, class... Family>
constexpr TargetTable<S> table_of(TypeList<Family...> /*families*/) {
  return {families<Target, S, Family...>, divide<S>, Chains<S, 12, 0>::work(), Chains<S, 7, 7>::work(),
          &GroupsOf<Target, S>::table};
}

}  // namespace HWY_NAMESPACE

template <class Target, class Scalar>
constinit const TargetTable<Scalar> TableOf<Target, Scalar>::table =
    HWY_NAMESPACE::table_of<Target, Scalar>(Families());

}  // namespace bezierbench::batch
