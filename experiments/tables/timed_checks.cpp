// SPDX-License-Identifier: MIT
#include "experiments/tables/timed_checks.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiments/metric/observed_error.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"
#include "experiments/tables/judged_tables.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::tables {
namespace {

/// The cell and the method of a row, without its study.
using JudgedCell = std::vector<std::string>;

JudgedCell judged_cell(const TableRow& row) {
  JudgedCell key;
  for (const auto& column : cell_columns())
    if (column != "study") key.push_back(row.text(column));
  return key;
}

/// The largest errors that accuracy studies saw.
std::map<JudgedCell, double> observed_errors(const Tables& tables) {
  std::vector<bundle::CsvDocument> accuracies;
  for (const auto& [file, table] : tables.all())
    if (file == "accuracy.csv" || file == "unstable.csv") accuracies.push_back(bundle::parse_csv(table.text(), file));
  std::map<JudgedCell, double> observed;
  JudgedTables(std::move(accuracies), std::nullopt).each_row("", [&](const TableRow& row) {
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
  const std::string file = "timing.csv";
  if (!tables.all().contains(file)) return;
  const auto timing = bundle::parse_csv(tables.table(file).text(), file);
  const auto observed = observed_errors(tables);
  bundle::CsvTable checked(timing.header());
  for (std::size_t at = 0; at < timing.row_count(); ++at) {
    const TableRow row(timing, at);
    auto fields = timing.row(at);
    if (const auto seen = row.optional_number("max_error_u")) {
      const auto found = observed.find(judged_cell(row));
      const double allowed = metric::allowed_error_u(
          found == observed.end() ? std::nullopt : std::optional(found->second), unit_roundoff_of(row));
      fields[timing.column("allowed_error_u")] = number::decimal(allowed);
      if (!(*seen <= allowed)) fields[timing.column("checked")] = "no";
    }
    checked.add_row(std::move(fields));
  }
  tables.table(file) = std::move(checked);
}

}  // namespace bezierbench::tables
