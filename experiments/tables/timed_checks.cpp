// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "experiments/metric/tally.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/table_row.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::tables {
namespace {

/// The cell and the method of a row, without its study.
using JudgedCell = std::vector<Field>;

JudgedCell judged_cell(const TableRow& row) {
  JudgedCell key;
  for (const auto& column : cell_columns())
    if (column != "study") key.push_back(row.field(column));
  return key;
}

/// The largest errors that accuracy studies saw.
std::map<JudgedCell, double> observed_errors(const Tables& tables) {
  std::map<JudgedCell, double> observed;
  JudgedTables(tables).each_row("", [&](const TableRow& row) {
    double& largest = observed[judged_cell(row)];
    largest = std::max(
        largest, row.number("non_finite") == 0 ? row.number("max_error_u") : std::numeric_limits<double>::infinity());
  });
  return observed;
}

double unit_roundoff_of(const TableRow& row) {
  const bool in_float = row.text("scalar") == suite::name(suite::ScalarKind::float32);
  return (in_float ? reference::float_arithmetic : reference::double_arithmetic).unit_roundoff;
}

}  // namespace

void check_timed_errors(Tables& tables) {
  const auto file = "timing.csv";
  if (tables.find(file) == nullptr) return;
  const auto observed = observed_errors(tables);
  for (Row& timed : tables.table(file).rows()) {
    const TableRow row(timed);
    const auto seen = row.optional_number("max_error_u");
    if (!seen) continue;
    const auto found = observed.find(judged_cell(row));
    const double allowed = metric::allowed_error_u(
        found == observed.end() ? std::nullopt : std::optional(found->second), unit_roundoff_of(row));
    timed.replace("allowed_error_u", allowed);
    if (!(*seen <= allowed)) timed.replace("checked", field("no"));
  }
}

}  // namespace bezierbench::tables
