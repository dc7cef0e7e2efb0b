// SPDX-License-Identifier: MIT
// The properties that compare points of a method with other points of the same method, or with its control points.
#pragma once

#include "experiments/requirements/requirements.hpp"

namespace bezierbench::requirements {

Outcome reproduces_constants(const Evaluator& method);
Outcome is_affinely_invariant(const Evaluator& method);
Outcome reverses_with_its_control_points(const Evaluator& method);
Outcome scales_with_powers_of_two(const Evaluator& method);
Outcome treats_axes_alike(const Evaluator& method);
Outcome gives_the_same_in_batches(const Evaluator& method);
Outcome interpolates_end_points(const Evaluator& method);

}  // namespace bezierbench::requirements
