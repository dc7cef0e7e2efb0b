// SPDX-License-Identifier: MIT
#include "experiments/cli/check/judged_cells.hpp"

#include <algorithm>
#include <limits>

#include "experiments/bundle/check/checked_reader.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/cli/commands/row_words.hpp"
#include "experiments/compare/row_match.hpp"
#include "experiments/tables/table_row.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::string_view in_bound_units = "max_error_u";
constexpr std::string_view in_coordinates = "max_error";

/// The error of a row in units of u p~ where the table has it, else in coordinate units.
std::optional<double> largest_error(const tables::TableRow& row) {
  for (const auto column : {in_bound_units, in_coordinates})
    if (row.has(column)) return row.optional_number(column);
  return std::nullopt;
}

void add(JudgedCells& all, const tables::TableRow& row, const compare::Inputs& inputs) {
  ++all.cells;
  all.trials += row.optional_number("trials").value_or(0);
  all.violations += row.optional_number("bound_violations").value_or(0);
  all.non_finite += row.optional_number("non_finite").value_or(0);
  const auto error = largest_error(row);
  if (!error) return;
  if (!all.worst || *error > *all.worst) {
    all.worst = error;
    all.in_u = row.has(in_bound_units);
    all.where = row_words(inputs);
  }
  const auto bound = row.optional_number("bound_u");
  if (bound && *bound > 0 && row.has(in_bound_units))
    all.bound_used = std::max(all.bound_used.value_or(0), *error / *bound);
}

}  // namespace

JudgedCells judged_cells(const std::filesystem::path& bundle, const std::string& method) {
  JudgedCells all;
  bundle::CheckedReader reader(bundle, bundle::Damage::refused);
  for (const auto& declared : bundle::declared_tables()) {
    if (declared.method.empty() || declared.column("status") == nullptr || !reader.has(declared.file)) continue;
    const auto table = bundle::parse_csv(reader.read(declared.file), reader.place(declared.file));
    for (std::size_t at = 0; at < table.row_count(); ++at) {
      const tables::TableRow row(table, at);
      const bool against_truth = !row.has("baseline") || row.text("baseline") == "exact";
      if (row.text(declared.method) == method && row.text("status") == "ok" && against_truth)
        add(all, row, compare::Inputs(declared, table, at, table));
    }
  }
  return all;
}

}  // namespace bezierbench::cli
