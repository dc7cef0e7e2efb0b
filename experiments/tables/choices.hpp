// SPDX-License-Identifier: MIT
// The error and the time of each method of a bundle side by side, as the basis of a choice between methods.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/tables/table_row.hpp"
#include "experiments/tables/tables.hpp"

namespace bezierbench::tables {

/// The observed and the proved largest error of a method, in one unit.
struct LargestError {
  double observed = 0;                ///< over all trials; infinite where a result was not finite
  std::optional<double> bound;        ///< the largest bound of these trials; empty where one of them has none
  std::optional<double> class_bound;  ///< bound over all curves and t of the requested class; empty without one

  /// Adds what further trials observed and what is proved of them. `is_first` if these are the first trials.
  void add(double seen, std::optional<double> proved, bool is_first);
};

struct LargestErrors {
  LargestError in_u;      ///< in units of u p~
  LargestError absolute;  ///< in coordinate units
  std::size_t rows = 0;   ///< number of rows added

  /// Adds a row of accuracy.csv or unstable.csv, as if its curves were `scale` times as large.
  void add(const TableRow& row, double scale = 1);
};

struct Choice {
  std::string method;
  metric::Interval ns;  ///< per point
  std::string quality;  ///< of the time; a word of timing.csv
  LargestErrors errors;
  std::optional<metric::Interval> ratio = {};  ///< of the time to that of `relative_to`, in the same race
  std::string relative_to = {};
  std::optional<double> instructions = {};  ///< per point, where they were counted

  /// What the methods of a race are ordered by: the ratio, whose interval does not grow with the speed of the machine.
  [[nodiscard]] const metric::Interval& time() const { return ratio ? *ratio : ns; }
};

/// The methods that raced each other in one race and were judged in one accuracy study.
struct ChoiceGroup {
  std::string study;           ///< the timing study
  std::string accuracy_study;  ///< the accuracy study
  std::string form;
  std::string scalar;
  std::string dimension;
  std::string degree;
  std::string mode;
  std::vector<std::string> drawn;  ///< the race's coordinate_range, t_min, t_max, generator; empty in old bundles
  std::vector<Choice> choices;
};

/// All groups, in the order of the rows of timing.csv, with the methods that were timed and without their errors.
/// Throws Failure(input_output) for a table without a required column.
std::vector<ChoiceGroup> timed_groups(const std::vector<TableRow>& timing);

/// All groups with errors. Of several accuracy studies of the same kind of curves, the one that judged most of the
/// timed methods is taken (of equals the first), since errors of different inputs cannot be compared. Methods that the
/// study did not judge are left out. Throws Failure(input_output) for tables that lack a column.
std::vector<ChoiceGroup> choice_groups(const std::vector<TableRow>& timing, const JudgedTables& judged);

/// Writes `pareto.csv` from the other tables, if there are both times and errors.
void write_pareto(Tables& tables);

}  // namespace bezierbench::tables
