// SPDX-License-Identifier: MIT
// The kernels that a study's `methods` and `baseline` name, for one scalar type and dimension.
#pragma once

#include <string>
#include <vector>

#include "core/evaluate/kernel.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::judge {

/// Every method that `study.methods` names and that takes curves of this form, in roster order; all of them when it
/// names none. Other libraries' methods must be named. Throws Failure(usage) for an id that exists only for another
/// form, scalar or dimension.
template <class Scalar>
std::vector<const Kernel<Scalar>*> chosen_kernels(const suite::Study& study, int dimension);

}  // namespace bezierbench::judge
