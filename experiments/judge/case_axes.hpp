// SPDX-License-Identifier: MIT
// The case axes of a companion problem: what a study varies besides the curves (order, tolerance, points, data). Their
// columns tell rows apart and are empty for other problems.
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

/// Which of these a problem has.
struct CaseAxes {
  bool degree = true;  ///< of curves; else the points are all that is given
  bool order = false;
  bool tolerance = false;
  bool points = false;
  bool data = false;  ///< every kind of data is a case
};

/// order,tolerance,points,data
const std::vector<std::string>& case_columns();

/// The fields of those columns.
std::vector<std::string> case_fields(const CaseValues& case_values);

/// The cross product of the study's case axes, order outermost; a single case without values where `asks` has no axis.
/// Throws Failure(usage), which names `problem`, for a key that is missing or that belongs to another problem.
std::vector<CaseValues> cases_of(const suite::Study& study, const CaseAxes& axes, std::string_view problem);

}  // namespace bezierbench::judge
