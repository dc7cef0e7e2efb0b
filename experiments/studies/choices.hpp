// SPDX-License-Identifier: MIT
// How wrong and how slow each method of a bundle is, side by side: what a choice between them rests on.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/studies/job.hpp"

namespace bezierbench::studies {

/// What was seen, and what is proved, of the largest error of a method, in one unit.
struct LargestError {
  double observed = 0;          ///< over all trials of the accuracy study; infinite where a result was not finite
  std::optional<double> bound;  ///< the largest bound of these trials; empty where one of them has none
};

struct Choice {
  std::string method;
  metric::Interval ns;    ///< per point
  std::string quality;    ///< of the time, as in timing.csv
  LargestError in_u;      ///< in units of u p~
  LargestError absolute;  ///< in coordinate units
};

/// The methods that raced each other in one heat and were judged in one accuracy study.
struct ChoiceGroup {
  std::string study;           ///< that timed them
  std::string accuracy_study;  ///< that judged them
  std::string curve;
  std::string scalar;
  std::string dimension;
  std::string degree;
  std::string mode;
  std::vector<std::string> drawn;  ///< the heat's coordinate_range, t_min, t_max, generator; empty in old bundles
  std::vector<Choice> choices;
};

/// All groups, in the order of timing.csv. `accuracies` are accuracy.csv and unstable.csv, as far as they are there.
/// Of several accuracy studies of such curves the one that judged most of the timed methods is taken (of equals the
/// first; `accuracy_study`, if given, is the only one considered): errors of different inputs compare badly. A method
/// that it did not judge is left out. Throws Failure(input_output) for tables without the columns.
std::vector<ChoiceGroup> choice_groups(const bundle::CsvDocument& timing,
                                       std::span<const bundle::CsvDocument> accuracies,
                                       const std::string& accuracy_study = "");

/// Writes `pareto.csv` from the other tables, where there are both times and errors.
void write_pareto(Tables& tables);

}  // namespace bezierbench::studies
