// SPDX-License-Identifier: MIT
// What the rows of a table say against a method, by the rules of tables.schema.json.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::bundle {

/// The methods for which methods.csv states neither a bound nor a promise. External methods are not in it.
[[nodiscard]] std::set<std::string, std::less<>> methods_without_promise(const CsvDocument& methods_csv);

/// The lines that tell which rows of the table `file` accuse a method, for example of broken promises. Columns that
/// accuse only a broken promise say nothing against the methods `without_promise`.
[[nodiscard]] std::vector<std::string> row_faults(const std::string& file, const CsvDocument& table,
                                                  const std::set<std::string, std::less<>>& without_promise);

}  // namespace bezierbench::bundle
