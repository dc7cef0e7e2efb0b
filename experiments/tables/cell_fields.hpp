// SPDX-License-Identifier: MIT
// How a row of a result says which cell it belongs to; one spelling for every file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::tables {

/// study,curve,method,scalar,dimension,degree,coordinate_range,t_min,t_max,generator
const std::vector<std::string>& cell_columns();

/// The fields of those columns.
std::vector<std::string> cell_fields(const suite::Study& study, const sample::Cell& cell, std::string_view method,
                                     suite::ScalarKind scalar);

/// coordinate_range,t_min,t_max,generator: how the inputs of a cell were drawn; the last of the columns above.
const std::vector<std::string>& drawn_columns();

/// The fields of those columns.
std::vector<std::string> drawn_fields(const sample::Cell& cell);

/// Those of cell_columns() for a sentence, without the method.
std::string describe(const suite::Study& study, const sample::Cell& cell, suite::ScalarKind scalar);

}  // namespace bezierbench::tables
