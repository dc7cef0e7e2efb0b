// SPDX-License-Identifier: MIT
// Asks functions, of a plug-in or of a method that was compiled in, in a child process that watches what they do.
#pragma once

#include <functional>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/outside/batch.hpp"
#include "experiments/outside/child.hpp"

namespace bezierbench::outside {

/// Opens the kernel for a dimension; called in the child. Null where it cannot be had; says why on standard error.
using OpenKernel = std::function<const Kernel<double>*(int dimension)>;

/// The kernel's `prepare` may throw this, where the method does not take the curve.
struct CurveRefused {};

/// The points of a batch, each curve prepared, evaluated and destroyed in turn. In the child room before and behind the
/// results, the inputs and the floating-point environment are checked after the last of them, and the memory that the
/// C library has given out is compared after each quarter of the batch.
Answer ask_code(const OpenKernel& open, const Batch& batch, const Limits& limits, bool (*stop)());

/// In a child: whether arithmetic is IEEE 754 to nearest with subnormals, as it was before the method was called.
bool has_usual_arithmetic();

/// How a child that gave no answer ended.
Answer failed(const Ended& ended);

}  // namespace bezierbench::outside
