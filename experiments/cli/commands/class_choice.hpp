// SPDX-License-Identifier: MIT
// A choice between methods for a class of curves: every row of the bundle that speaks of the class, and what is proved
// of all of it.
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

/// The class that was timed, or with another range. An older bundle does not say how timed curves were drawn: then it
/// is the widest class that was judged. Nothing where neither says.
std::optional<DrawnClass> class_of(const tables::ChoiceGroup& group, const tables::JudgedTables& judged,
                                   std::optional<double> range);

/// On curves of which ranges some of the group's methods were judged, ascending; in `accuracy_study` only if that is
/// not empty.
std::vector<double> judged_ranges(const tables::ChoiceGroup& group, const tables::JudgedTables& judged,
                                  const std::string& accuracy_study);

/// Fills in the errors of the group's methods anew: over all rows, of `accuracy_study` only if that is not empty, whose
/// range and interval lie within the class, and the bound of the class. Leaves out methods of which no row is of the
/// class itself. `methods` is methods.csv: where it states another bound than this program does, that proves nothing.
void judge_class(tables::ChoiceGroup& group, const DrawnClass& of, const tables::JudgedTables& judged,
                 const std::optional<bundle::CsvDocument>& methods, const std::string& accuracy_study);

/// From which p~ on bounds in units of u p~ are proved for the class.
double least_p_tilde(const tables::ChoiceGroup& group, const DrawnClass& of);

}  // namespace bezierbench::cli
