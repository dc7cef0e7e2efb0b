// SPDX-License-Identifier: MIT
// What the rows of a table say against a method, by the rules of tables.schema.json.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::bundle {

/// The citation that methods.csv has for methods from outside of the program.
inline constexpr std::string_view external_citation = "external method";

/// What methods.csv states of methods.
struct MethodFacts {
  std::set<std::string, std::less<>> promising;  ///< with a bound or a promise
  std::set<std::string, std::less<>> external;
};
[[nodiscard]] MethodFacts method_facts(const CsvDocument& methods_csv);

/// The lines that tell which rows of the table `file` accuse a method, for example of broken promises.
[[nodiscard]] std::vector<std::string> row_faults(const std::string& file, const CsvDocument& table,
                                                  const MethodFacts& methods);

}  // namespace bezierbench::bundle
