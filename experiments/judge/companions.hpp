// SPDX-License-Identifier: MIT
// The methods of the companion problems: derivative, arc length, projection, interpolation, fitting.
#pragma once

#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::judge {

/// The info of every method of every companion problem, problem by problem in roster order.
std::vector<const MethodInfo*> companion_infos();

/// The methods of one problem that `study.methods` names, in roster order; all of them where it names none. Throws
/// Failure(usage) for an entry that names no method of this problem.
std::vector<const MethodInfo*> chosen_companions(const suite::Study& study, Problem problem);

/// Throws Failure(usage) where no method that was chosen takes curves of the study's form.
void require_form(const suite::Study& study, bool any_method);

}  // namespace bezierbench::judge
