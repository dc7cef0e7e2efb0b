// SPDX-License-Identifier: MIT
// The kernels that a study's `methods` and `baseline` name, for one scalar type and dimension.
#pragma once

#include <string>
#include <vector>

#include "core/evaluate/kernel.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::judge {

/// True where the method has points at every t of the interval.
bool takes(const MethodInfo& info, const suite::Interval& t_interval);

/// Every method that `study.methods` names and that takes curves of the study's form at the t of the cell, in roster
/// order; all of them when it names none. Other libraries' methods must be named. Throws Failure(usage) for an id that
/// exists only for another form, scalar or dimension, or for none of the t of the study.
template <class Scalar>
std::vector<const Kernel<Scalar>*> chosen_kernels(const suite::Study& study, const sample::Cell& cell);

}  // namespace bezierbench::judge
