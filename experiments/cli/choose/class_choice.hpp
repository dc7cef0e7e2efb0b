// SPDX-License-Identifier: MIT
// A choice between methods for a class of curves, based on the bundle's rows within the class and on proved bounds.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "experiments/metric/class_bound.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/choices.hpp"

namespace bezierbench::cli {

/// The curves with coordinates in [-range, range], at parameters in the interval.
struct DrawnClass {
  double range = 0;
  suite::Interval t;
  /// What is known of it is known of coordinates in [-range, range] 2^-exponent: no method's roundings depend on a power
  /// of two, as long as no number leaves the range of normal ones.
  int exponent = 0;

  [[nodiscard]] double judged_range() const { return std::ldexp(range, -exponent); }
};

/// The class that was timed, with another range if one is given. Empty where timing.csv does not state it in numbers.
std::optional<DrawnClass> class_of(const tables::ChoiceGroup& group, std::optional<double> range);

/// The ranges of the curves on which methods of the group were judged, ascending. Only `accuracy_study` counts, unless
/// it is empty.
std::vector<double> judged_ranges(const tables::ChoiceGroup& group, const tables::JudgedTables& judged,
                                  const std::string& accuracy_study);

/// The class itself, where its range is one of those that were judged, else the smallest that contains it and has one of
/// these ranges times a power of two. Empty where the curves are so large or small that methods may overflow or underflow.
/// Of several such ranges that of the timed curves is taken, `timed`, then the nearest.
std::optional<DrawnClass> scaled_to(DrawnClass of, double timed, const std::vector<double>& judged, bool in_float);

/// Sets the errors of the group's methods over all rows whose range and interval lie within the class, and the bounds
/// of the class. Only rows of `accuracy_study` count, unless it is empty. Removes methods without a row for the class
/// itself. `methods` is methods.csv: a bound is used only if the one stated there is that of this program. Returns the
/// cells of these rows in words, each once: `truth: R 1, t in [0, 1], continuous, 1000 trials`.
std::vector<std::string> judge_class(tables::ChoiceGroup& group, const DrawnClass& of,
                                     const tables::JudgedTables& judged,
                                     const std::optional<bundle::CsvDocument>& methods,
                                     const std::string& accuracy_study);

/// The least p~ to which bounds in units of u p~ apply in the class.
double least_p_tilde(const tables::ChoiceGroup& group, const DrawnClass& of);

}  // namespace bezierbench::cli
