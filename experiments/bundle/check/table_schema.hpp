// SPDX-License-Identifier: MIT
// Checks of a bundle's tables against schema/tables.schema.json: which tables there are, their columns, and the values
// of their fields.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::bundle {

/// Whether a bundle can have a table of this name.
[[nodiscard]] bool is_table_name(std::string_view name);

/// What is wrong with the table `name`: a few lines, each with file and line, and the number of further ones.
[[nodiscard]] std::vector<std::string> table_faults(std::string_view name, const CsvDocument& table);

}  // namespace bezierbench::bundle
