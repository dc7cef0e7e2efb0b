// SPDX-License-Identifier: MIT
#include "core/batch/target_kernels.hpp"
#include "core/batch/targets.hpp"

namespace bezierbench::batch {

static_assert(HWY_TARGET == HWY_NEON, "this file is compiled with the flags of its target");

template <>
constinit const TargetTable<double> Tables<double>::neon = HWY_NAMESPACE::table_of<double>(Unfused{}, Fused{});

}  // namespace bezierbench::batch
