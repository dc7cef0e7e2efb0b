// SPDX-License-Identifier: MIT
// What a companion problem is asked besides its curves: the columns that tell its rows apart, empty for other problems.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/suite/suite.hpp"

namespace bezierbench::judge {

struct CaseValues {
  std::optional<int> order = std::nullopt;         ///< of a derivative
  std::optional<double> tolerance = std::nullopt;  ///< relative for lengths, a distance for fits
  std::optional<int> points = std::nullopt;        ///< number of data points
  std::string_view data = {};                      ///< id of a sample::DataKind
  friend bool operator==(const CaseValues&, const CaseValues&) = default;
};

/// order,tolerance,points,data
const std::vector<std::string>& case_columns();

/// The fields of those columns.
std::vector<std::string> case_fields(const CaseValues& case_values);

/// The cross product of what a timing study asks, order outermost; one that asks nothing where it has no such key.
/// `each_data`: every kind of data is a case of its own.
std::vector<CaseValues> cases_of(const suite::Study& study, bool each_data);

}  // namespace bezierbench::judge
