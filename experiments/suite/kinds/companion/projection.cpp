// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/companion/projection.hpp"

#include "experiments/suite/kinds.hpp"

namespace bezierbench::suite {

const Kind& ProjectionKeys::kind() {
  static constexpr Kind kind{.id = "projection",
                             .about = "errors of foot points, and feet that are missed",
                             .own = {},
                             .methods_example = "[\"quintic_isolate\"]",
                             .inputs = {.forms = bernstein_form,
                                        .forms_reason = "foot points are sought on polynomial Bezier curves",
                                        .double_only = true,
                                        .independent_points = true},
                             .companion = Problem::projection,
                             .keys = default_keys<ProjectionKeys>};
  return kind;
}

}  // namespace bezierbench::suite
