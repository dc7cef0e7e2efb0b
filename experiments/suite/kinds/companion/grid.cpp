// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/companion/grid.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr Field grid_points_key{.key = "points",
                                .meaning = "numbers of points of the grid, each a power of two and one, 2 to 524289",
                                .example = "[17, 257]",
                                .needed = true,
                                .axis = Axis::of_cases};

static_assert(most_grid_points == 524289, "the meaning of points states it");

constexpr std::array grid_fields{field<&GridKeys::points>(grid_points_key)};

Finding check_grid(const Study& study, const Vocabulary& /*known*/) {
  return check_grid_points(keys_of<GridKeys>(study).points);
}

}  // namespace

const Kind& GridKeys::kind() {
  static constexpr Kind kind{.id = "grid",
                             .about = "errors of the points on a uniform grid",
                             .own = grid_fields,
                             .methods_example = "[\"forward_differencing\"]",
                             .inputs = {.forms = polynomial_forms,
                                        .forms_reason = "grids are of polynomial curves",
                                        .double_only = true,
                                        .parameters = Parameters::whole,
                                        .parameters_reason = "grids reach from 0 to 1"},
                             .companion = Problem::grid,
                             .keys = default_keys<GridKeys>,
                             .check = check_grid};
  return kind;
}

}  // namespace bezierbench::suite
