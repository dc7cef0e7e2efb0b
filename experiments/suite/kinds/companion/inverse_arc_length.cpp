// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/companion/inverse_arc_length.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array inverse_arc_length_fields{field<&InverseArcLengthKeys::tolerance>(
    tolerance_key("tolerances that the methods are given, relative to the length of the whole curve", "[1e-3, 1e-6]"))};

Finding check_inverse_arc_length(const Study& study, const Vocabulary& /*known*/) {
  return check_tolerances(keys_of<InverseArcLengthKeys>(study).tolerance);
}

}  // namespace

const Kind& InverseArcLengthKeys::kind() {
  static constexpr Kind kind{.id = "inverse_arc_length",
                             .about = "errors of the parameter at a length, and whether tolerances are kept",
                             .own = inverse_arc_length_fields,
                             .methods_example = "[\"bracketed_newton\"]",
                             .inputs = {.forms = bernstein_form,
                                        .forms_reason = "lengths are those of polynomial Bezier curves",
                                        .double_only = true,
                                        .parameters = Parameters::from_0_to_1,
                                        .parameters_reason = "the share of the length at which t is sought"},
                             .companion = Problem::inverse_arc_length,
                             .keys = default_keys<InverseArcLengthKeys>,
                             .check = check_inverse_arc_length};
  return kind;
}

}  // namespace bezierbench::suite
