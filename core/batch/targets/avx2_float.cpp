// SPDX-License-Identifier: MIT
#include "core/batch/target_kernels.hpp"
#include "core/batch/targets.hpp"

namespace bezierbench::batch {

static_assert(HWY_TARGET == HWY_AVX2, "this file is compiled with the flags of its target");

template <>
constinit const TargetTable<float> Tables<float>::avx2 = HWY_NAMESPACE::table_of<float>(Unfused{}, Fused{});

}  // namespace bezierbench::batch
