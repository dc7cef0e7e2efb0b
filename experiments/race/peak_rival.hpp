// SPDX-License-Identifier: MIT
// The peak of a target as a rival: fixed work that fills its arithmetic units, in the same race as the methods.
#pragma once

#include "core/batch/batch.hpp"
#include "experiments/race/rounds.hpp"

namespace bezierbench::race {

/// A point is one floating-point operation. `work` is of fused multiply-adds, with others beside them or not, for a
/// target that this processor can run.
template <class Scalar>
Rival peak_rival(const batch::OperationWork<Scalar>& work);

}  // namespace bezierbench::race
