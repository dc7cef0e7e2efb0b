// SPDX-License-Identifier: MIT
// Methods that are code: a plug-in, or a method that was compiled in. Both are called in child processes.
#pragma once

#include <functional>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/external/child.hpp"
#include "experiments/external/method.hpp"

namespace bezierbench::external {

/// Opens the kernel for a dimension; called in the child. Null where it is not available, which it reports on standard
/// error.
using OpenKernel = std::function<const Kernel<double>*(int dimension)>;

/// The kernel's `prepare` may throw this, where the method does not take the curve.
struct CurveRefused {};

/// The points of a batch, each curve prepared, evaluated and destroyed in turn.
Answer call_code(const OpenKernel& open, const Batch& batch, const Limits& limits, bool (*stop)());

/// The status of a child that gave no answer.
Answer failed(const Ended& ended);

}  // namespace bezierbench::external
