// SPDX-License-Identifier: MIT
#include "core/batch/target_kernels.hpp"
#include "core/batch/targets.hpp"

namespace bezierbench::batch {

static_assert(HWY_TARGET == HWY_AVX3, "this file is compiled with the flags of its target");

template <>
constinit const TargetTable<float> Tables<float>::avx512 = HWY_NAMESPACE::table_of<float>(Unfused{}, Fused{});

}  // namespace bezierbench::batch
