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

/// Throws Failure(usage) unless the study is of Bezier curves in double: some problems have methods for these only.
void check_bezier_in_double(const suite::Study& study);

/// Throws Failure(usage) for a generator that draws whole curves only and no separate points.
void check_independent_points(const suite::Study& study);

}  // namespace bezierbench::judge
