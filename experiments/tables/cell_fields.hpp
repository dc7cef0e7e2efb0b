// SPDX-License-Identifier: MIT
// The columns and fields of a row that identify its cell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/field.hpp"

namespace bezierbench::tables {

/// study,form,method,scalar,dimension,degree,coordinate_range,t_min,t_max,generator,curves
const std::vector<std::string>& cell_columns();

/// The fields of cell_columns().
std::vector<Field> cell_fields(const suite::Study& study, const sample::Cell& cell, std::string_view method,
                               suite::ScalarKind scalar);

/// coordinate_range,t_min,t_max,generator,curves: how the inputs of a cell were drawn, or which curve set they are from; then the
/// generator is the placement of its curves. These are the last of cell_columns().
const std::vector<std::string>& drawn_columns();

/// The fields of drawn_columns().
std::vector<Field> drawn_fields(const sample::Cell& cell);

/// The fields of cell_columns() without the method, as text for a message.
std::string describe(const suite::Study& study, const sample::Cell& cell, suite::ScalarKind scalar);

}  // namespace bezierbench::tables
