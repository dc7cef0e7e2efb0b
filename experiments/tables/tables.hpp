// SPDX-License-Identifier: MIT
// The tables of a bundle while they grow, and what the scorecard compares with printed cells.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::tables {

/// The CSV files of a bundle while they grow, by file name.
class Tables {
 public:
  /// The table of this name, made with these columns when first asked for.
  bundle::CsvTable& table(const std::string& file, const std::vector<std::string>& columns);
  [[nodiscard]] const std::map<std::string, bundle::CsvTable>& all() const { return tables_; }

 private:
  std::map<std::string, bundle::CsvTable> tables_;
};

/// One statistic of one cell, once per replicate: what a printed cell of a report is compared with.
struct Series {
  std::string study;
  std::string curve;
  std::string method;
  std::string statistic;  ///< mean_error, max_error, count_within_1e-5, ..., total_time
  std::string degree;     ///< a number, or first..last for statistics over degrees
  double coordinate_range = 0;
  std::optional<suite::Interval> t_interval;
  std::string generator;
  std::string baseline;  ///< exact or a method id; empty for times
  std::string mode;      ///< of a timing; empty otherwise
  std::vector<double> values;
};

}  // namespace bezierbench::tables
