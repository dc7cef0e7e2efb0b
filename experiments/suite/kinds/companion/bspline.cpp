// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/companion/bspline.hpp"

#include "experiments/suite/kinds.hpp"

namespace bezierbench::suite {

const Kind& BsplineKeys::kind() {
  static constexpr Kind kind{
      .id = "bspline",
      .about = "errors of points and Bernstein control points of a knot span of a B-spline curve",
      .own = {},
      .methods_example = "[\"de_boor\"]",
      .inputs = {.forms = bernstein_form,
                 .forms_reason = "B-spline curves without weights are studied",
                 .double_only = true,
                 .least_degree = 1,
                 .least_degree_reason = "B-spline curves of degree 0 are not continuous",
                 .parameters = Parameters::from_0_to_1,
                 .parameters_reason = "the part of the knot span in which parameters lie",
                 .independent_points = true},
      .companion = Problem::bspline,
      .keys = default_keys<BsplineKeys>};
  return kind;
}

}  // namespace bezierbench::suite
