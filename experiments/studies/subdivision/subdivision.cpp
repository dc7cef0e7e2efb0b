// SPDX-License-Identifier: MIT
// Studies of kind `subdivision`: random curves split at random t; every control point of both halves is judged against
// the exact one.

#include "experiments/studies/subdivision/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"

namespace bezierbench::studies {

extern constexpr StudyKind subdivision_kind =
    companion_kind<SubdivisionProblem>({.id = "subdivision",
                                        .about = "errors of the control points of both halves of a split curve",
                                        .own = {},
                                        .methods_example = "[\"de_casteljau_split\"]",
                                        .inputs = {.forms = suite::forms_with_control_points,
                                                   .forms_reason = "what is split has control points",
                                                   .double_only = true}});

}  // namespace bezierbench::studies
