// SPDX-License-Identifier: MIT
// The properties that compare points with the exact ones.
#pragma once

#include "experiments/requirements/requirements.hpp"

namespace bezierbench::requirements {

// Methods without a bound must not be asked for the first three.
Outcome keeps_its_bound(const Evaluator& method);
Outcome keeps_its_bound_in_float(const Evaluator& method);
Outcome keeps_its_bound_where_it_underflows(const Evaluator& method);

/// Even a method without a bound is right to first order where nothing is amplified much.
Outcome is_right_on_mild_curves(const Evaluator& method);

}  // namespace bezierbench::requirements
