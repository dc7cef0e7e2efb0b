// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/companion/subdivision.hpp"

#include "experiments/suite/kinds.hpp"

namespace bezierbench::suite {

const Kind& SubdivisionKeys::kind() {
  static constexpr Kind kind{.id = "subdivision",
                             .about = "errors of the control points of both halves of a split curve",
                             .own = {},
                             .methods_example = "[\"de_casteljau_split\"]",
                             .inputs = {.forms = forms_with_control_points,
                                        .forms_reason = "what is split has control points",
                                        .double_only = true},
                             .companion = Problem::subdivision,
                             .keys = default_keys<SubdivisionKeys>};
  return kind;
}

}  // namespace bezierbench::suite
