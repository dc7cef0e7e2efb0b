// SPDX-License-Identifier: MIT
// A choice between methods for a class of curves, by the bundle's rows within the class and the bounds that are proved
// for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/metric/class_bound.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/choices.hpp"

namespace bezierbench::cli {

/// Curves with coordinates in [-range, range], at parameters of the interval.
struct DrawnClass {
  double range = 0;
  suite::Interval t;
};

/// The class that was timed, or the same with another range. Older bundles do not record how timed curves were drawn;
/// then it is the widest class that was judged. Empty where there is neither.
std::optional<DrawnClass> class_of(const tables::ChoiceGroup& group, const tables::JudgedTables& judged,
                                   std::optional<double> range);

/// The ranges of the curves on which methods of the group were judged, ascending; only those of `accuracy_study` unless
/// it is empty.
std::vector<double> judged_ranges(const tables::ChoiceGroup& group, const tables::JudgedTables& judged,
                                  const std::string& accuracy_study);

/// Computes the errors of the group's methods over all rows whose range and interval lie within the class (only those
/// of `accuracy_study` unless it is empty), and the bounds of the class. Removes methods without a row of the class
/// itself. `methods` is methods.csv: no bound is used for a method whose bound there differs from this program's.
void judge_class(tables::ChoiceGroup& group, const DrawnClass& of, const tables::JudgedTables& judged,
                 const std::optional<bundle::CsvDocument>& methods, const std::string& accuracy_study);

/// The least p~ for which bounds in units of u p~ are proved for the class.
double least_p_tilde(const tables::ChoiceGroup& group, const DrawnClass& of);

}  // namespace bezierbench::cli
