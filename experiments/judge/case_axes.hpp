// SPDX-License-Identifier: MIT
// The case axes of a companion problem: what a study varies besides the curves (order, tolerance, points, data, knots).
// Their columns distinguish rows and are empty for other problems.
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
  std::string_view placement = {};                 ///< id of a sample::Placement
  std::string_view knots = {};                     ///< id of a sample::KnotKind
  friend bool operator==(const CaseValues&, const CaseValues&) = default;
};

/// The axes of a problem that follow from the problem, not from the keys of its studies.
struct CaseAxes {
  bool degree = true;      ///< of curves; else the points are all that is given
  bool tolerance = false;  ///< every method is given one
  bool data = false;       ///< every kind of data is a case of its own
  bool placement = false;  ///< so is every placement; times are those of the first
  bool knots = false;      ///< so is every kind of knots; times are those of the first
};

/// A column that says which case a row is of; empty where the problem has no such axis.
struct CaseColumn {
  std::string_view name;
  std::string (*field)(const CaseValues& values);
};

namespace case_column {
std::string order_field(const CaseValues& values);
std::string tolerance_field(const CaseValues& values);
std::string points_field(const CaseValues& values);
inline constexpr CaseColumn order{"order", order_field};
inline constexpr CaseColumn tolerance{"tolerance", tolerance_field};
inline constexpr CaseColumn points{"points", points_field};
inline constexpr CaseColumn data{"data", [](const CaseValues& values) { return std::string(values.data); }};
inline constexpr CaseColumn placement{"placement",
                                      [](const CaseValues& values) { return std::string(values.placement); }};
inline constexpr CaseColumn knots{"knots", [](const CaseValues& values) { return std::string(values.knots); }};
}  // namespace case_column

/// order,tolerance,points,data: of times.
const std::vector<std::string>& case_columns();

/// The fields of those columns.
std::vector<std::string> case_fields(const CaseValues& case_values);

/// The cross product of the study's case axes, order outermost; a single case without values where it has none.
std::vector<CaseValues> cases_of(const suite::Study& study, const CaseAxes& axes);

}  // namespace bezierbench::judge
