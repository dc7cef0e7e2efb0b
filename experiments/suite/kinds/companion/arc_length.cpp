// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/companion/arc_length.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array arc_length_fields{field<&ArcLengthKeys::tolerance>(
    tolerance_key("tolerances that the methods are given, relative to the length", "[1e-3, 1e-6]"))};

Finding check_arc_length(const Study& study, const Vocabulary& /*known*/) {
  return check_tolerances(keys_of<ArcLengthKeys>(study).tolerance);
}

}  // namespace

const Kind& ArcLengthKeys::kind() {
  static constexpr Kind kind{.id = "arc_length",
                             .about = "errors of arc lengths, and whether tolerances are kept",
                             .own = arc_length_fields,
                             .methods_example = "[\"gauss_legendre_adaptive\"]",
                             .inputs = {.forms = bernstein_form,
                                        .forms_reason = "lengths are those of polynomial Bezier curves",
                                        .double_only = true,
                                        .parameters = Parameters::from_0_to_1,
                                        .parameters_reason = "the part to be measured"},
                             .companion = Problem::arc_length,
                             .keys = default_keys<ArcLengthKeys>,
                             .check = check_arc_length};
  return kind;
}

}  // namespace bezierbench::suite
