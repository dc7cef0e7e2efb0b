// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/companion/interpolation.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array interpolation_fields{field<&InterpolationKeys::points>(points_key)};

Finding check_interpolation(const Study& study, const Vocabulary& /*known*/) {
  return check_points(keys_of<InterpolationKeys>(study).points);
}

}  // namespace

const Kind& InterpolationKeys::kind() {
  static constexpr Kind kind{.id = "interpolation",
                             .about = "errors of splines through random points",
                             .own = interpolation_fields,
                             .methods_example = "[\"c2_natural\"]",
                             .inputs = {.forms = bernstein_form,
                                        .forms_reason = "splines are of polynomial Bezier curves",
                                        .double_only = true,
                                        .degree = DegreeUse::not_a_key,
                                        .degree_reason = "degree is that of the segments, 3",
                                        .parameters = Parameters::whole,
                                        .parameters_reason = "points are joined whole",
                                        .independent_points = true},
                             .companion = Problem::interpolation,
                             .keys = default_keys<InterpolationKeys>,
                             .check = check_interpolation};
  return kind;
}

}  // namespace bezierbench::suite
