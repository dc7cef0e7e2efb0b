// SPDX-License-Identifier: MIT
// Whether a bundle has the rows that its suite asks for: each once, and no other.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::bundle {

inline constexpr std::string_view methods_name = "methods.csv";

/// The tables of a bundle, by file name.
using TablesByName = std::map<std::string, CsvDocument, std::less<>>;

/// The rows that a run of a suite writes whatever its results are, and the methods that it chooses from.
struct Plan {
  TablesByName rows;        ///< with their keys only; a study that has a row in a table has no others there
  std::string methods_csv;  ///< methods.csv as this build writes it
  std::string git_commit;   ///< of this build; "unknown" outside a repository
  std::set<std::string, std::less<>> external;  ///< external methods, which have further rows where they do not fail
};

/// The lines that tell where the rows of `tables` are not those of the plan, or a table does not have the rows that its
/// declaration asks for (`for_each`). Only methods that methods.csv of the bundle
/// describes as this build does are held to it: another build may have others, or take them at other degrees. Rows of a
/// method that the bundle does not list are reported, and so are differences between the two lists where `git_commit`,
/// of the bundle, is that of this build. `place` is the folder.
[[nodiscard]] std::vector<std::string> coverage_faults(const Plan& plan, const TablesByName& tables,
                                                       const std::string& git_commit, const std::string& place);

/// The lines that tell which rows of a table have the keys of an earlier one.
[[nodiscard]] std::vector<std::string> repeated_rows(const std::string& file, const CsvDocument& table);

}  // namespace bezierbench::bundle
