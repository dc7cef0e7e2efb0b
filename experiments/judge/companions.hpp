// SPDX-License-Identifier: MIT
// The methods of the companion problems: derivative, arc length, projection, interpolation, fitting.
#pragma once

#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::judge {

/// What the methods of all companion problems say of themselves, problem by problem in roster order.
std::vector<const MethodInfo*> companion_infos();

/// Those of one problem that `study.methods` names, in roster order; all when it names none. Throws Failure(usage) for
/// an entry that names none of this problem.
std::vector<const MethodInfo*> chosen_companions(const suite::Study& study, Problem problem);

/// Throws Failure(usage) unless the study is of Bezier curves in double, which is all that some problems are solved
/// for.
void check_bezier_in_double(const suite::Study& study);

/// Throws Failure(usage) for a generator that draws a curve as a whole: no points of their own.
void check_independent_points(const suite::Study& study);

}  // namespace bezierbench::judge
