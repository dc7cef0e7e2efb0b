// SPDX-License-Identifier: MIT
#include "core/batch/operation_chains.hpp"
#include "core/batch/targets.hpp"

namespace bezierbench::batch {

static_assert(HWY_TARGET == HWY_AVX3, "this file is compiled with the flags of its target");

template <>
constinit const WorksOfWidths<float> Tables<float>::avx512_works = HWY_NAMESPACE::all_works<float>;

template <>
constinit const WorksOfWidths<double> Tables<double>::avx512_works = HWY_NAMESPACE::all_works<double>;

}  // namespace bezierbench::batch
