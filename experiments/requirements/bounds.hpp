// SPDX-License-Identifier: MIT
// The properties that compare points with the exact ones.
#pragma once

#include "experiments/requirements/requirements.hpp"

namespace bezierbench::requirements {

// Methods without a bound must not be asked for the first four.
Outcome keeps_its_bound(const Evaluator& method);
Outcome keeps_its_bound_in_float(const Evaluator& method);
Outcome keeps_its_bound_where_it_underflows(const Evaluator& method);
/// An error that is infinite, because a result overflows, is beyond every finite bound.
Outcome keeps_its_bound_up_to_overflow(const Evaluator& method);

/// The declared degrees are those at which coordinates of at most 1 give numbers.
Outcome works_up_to_its_largest_degree(const Evaluator& method);

/// Even a method without a bound is right to first order where nothing is amplified much.
Outcome is_right_on_mild_curves(const Evaluator& method);

}  // namespace bezierbench::requirements
