// SPDX-License-Identifier: MIT
// What the rows of a table say against a method, by the rules of tables.schema.json.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::bundle {

/// The methods for which methods.csv states a bound or a promise.
[[nodiscard]] std::set<std::string, std::less<>> promising_methods(const CsvDocument& methods_csv);

/// The lines that tell which rows of the table `file` accuse a method, for example of broken promises. `promising` are the
/// methods that promise something.
[[nodiscard]] std::vector<std::string> row_faults(const std::string& file, const CsvDocument& table,
                                                  const std::set<std::string, std::less<>>& promising);

}  // namespace bezierbench::bundle
