// SPDX-License-Identifier: MIT
// How wrong and how slow each method of a bundle is, side by side: what a choice between them rests on.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/tables/judged_tables.hpp"
#include "experiments/tables/tables.hpp"

namespace bezierbench::tables {

/// What was seen, and what is proved, of the largest error of a method, in one unit.
struct LargestError {
  double observed = 0;                ///< over all trials; infinite where a result was not finite
  std::optional<double> bound;        ///< the largest bound of these trials; empty where one of them has none
  std::optional<double> class_bound;  ///< of every curve and t of the class that is asked for, if one is proved

  /// What was seen and proved in further trials; `is_first` if there were none before.
  void add(double seen, std::optional<double> proved, bool is_first);
};

struct LargestErrors {
  LargestError in_u;      ///< in units of u p~
  LargestError absolute;  ///< in coordinate units
  std::size_t rows = 0;   ///< that were added

  /// A row of accuracy.csv or unstable.csv.
  void add(const JudgedTables& tables, const TableRow& row);
};

struct Choice {
  std::string method;
  metric::Interval ns;  ///< per point
  std::string quality;  ///< of the time, as in timing.csv
  LargestErrors errors;
};

/// The methods that raced each other in one race cell and were judged in one accuracy study.
struct ChoiceGroup {
  std::string study;           ///< that timed them
  std::string accuracy_study;  ///< that judged them
  std::string curve;
  std::string scalar;
  std::string dimension;
  std::string degree;
  std::string mode;
  std::vector<std::string> drawn;  ///< the race cell's coordinate_range, t_min, t_max, generator; empty in old bundles
  std::vector<Choice> choices;
};

/// All groups, in the order of timing.csv, with the methods that were timed; their errors are not known yet. Throws
/// Failure(input_output) for a table without the columns.
std::vector<ChoiceGroup> timed_groups(const bundle::CsvDocument& timing);

/// The same with errors. Of several accuracy studies of such curves the one that judged most of the
/// timed methods is taken (of equals the first; `accuracy_study`, if given, is the only one considered): errors of
/// different inputs compare badly. A method that it did not judge is left out. Throws Failure(input_output) for tables
/// without the columns.
std::vector<ChoiceGroup> choice_groups(const bundle::CsvDocument& timing, const JudgedTables& judged,
                                       const std::string& accuracy_study = "");

/// Writes `pareto.csv` from the other tables, where there are both times and errors.
void write_pareto(Tables& tables);

}  // namespace bezierbench::tables
