// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/companion/fitting.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array fitting_fields{
    field<&FittingKeys::points>(points_key),
    field<&FittingKeys::tolerance>(tolerance_key("distances from the data that a fit may have", "[1e-2, 1e-4]"))};

Finding check_fitting(const Study& study, const Vocabulary& /*known*/) {
  const auto& keys = keys_of<FittingKeys>(study);
  if (auto found = check_points(keys.points)) return found;
  return check_tolerances(keys.tolerance);
}

}  // namespace

const Kind& FittingKeys::kind() {
  static constexpr Kind kind{.id = "fitting",
                             .about = "segments and errors of fits to data of random curves",
                             .own = fitting_fields,
                             .methods_example = "[\"schneider\"]",
                             .inputs = {.forms = bernstein_form,
                                        .forms_reason = "data are taken from polynomial Bezier curves",
                                        .double_only = true,
                                        .least_degree = 1,
                                        .least_degree_reason = "data are taken from curves of degree 1 or more",
                                        .parameters = Parameters::whole,
                                        .parameters_reason = "data are taken from whole curves",
                                        .independent_points = true},
                             .companion = Problem::fitting,
                             .keys = default_keys<FittingKeys>,
                             .check = check_fitting};
  return kind;
}

}  // namespace bezierbench::suite
