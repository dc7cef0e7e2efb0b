// SPDX-License-Identifier: MIT
// Check, then time: only methods whose points are near the exact ones are worth a time.
#pragma once

#include "experiments/timing/kernel_rival.hpp"

namespace bezierbench::studies {

/// True where the kernel's points on these inputs are as near to the exact ones as a method may be: within its bound
/// or, where none is proved, within 64 (n+1) u times the amplification of a detour through the other form.
bool agrees_with_reference(const Kernel<double>& kernel, suite::Mode mode, const timing::Inputs& inputs);

}  // namespace bezierbench::studies
