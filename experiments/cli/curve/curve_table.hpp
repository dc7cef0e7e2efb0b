// SPDX-License-Identifier: MIT
// The table that a `curve` command prints, of one curve or of every curve of a file, and the fields of a judged coordinate
// in it.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/echo.hpp"
#include "reference/rational.hpp"

namespace bezierbench::cli {

/// The fields of the columns value,exact,error,error_ulp,error_u. Errors are infinite where `value` is not finite;
/// error_u is infinite where p~ is 0 and the error is not.
std::vector<std::string> judged_coordinate(double value, const reference::Rational& truth,
                                           const reference::Rational& p_tilde);

/// The field of the column bound_u: bound / (u p~); empty where the bound is infinite or p~ is 0.
std::string bound_field(double bound, const reference::Rational& p_tilde);

/// A table whose rows begin with the id of their curve if there are several.
class CurveTable {
 public:
  CurveTable(bool several, std::vector<std::string> columns)
      : several_(several), table_(begun_with("curve", std::move(columns))) {}

  /// Rows that are added from now on are those of the curve `id`.
  void begin(const std::string& id) { id_ = id; }
  void add_row(std::vector<std::string> fields) { table_.add_row(begun_with(id_, std::move(fields))); }
  [[nodiscard]] std::string text() const { return table_.text(); }

 private:
  [[nodiscard]] std::vector<std::string> begun_with(const std::string& first, std::vector<std::string> fields) const {
    if (several_) fields.insert(fields.begin(), first);
    return fields;
  }

  bool several_;
  std::string id_;
  bundle::CsvTable table_;
};

/// Calls add_rows(options, curve, table) for every curve that `options.curve` names, and prints the table. Of several
/// curves each gets the options that name it alone, so that messages say which curve they are about.
template <class Options, class AddRows>
void print_rows_of_curves(const Options& options, std::vector<std::string> columns, AddRows add_rows) {
  const auto curves = read_curves(options.curve.file, options.curve.form_value());
  CurveTable table(curves.size() > 1, std::move(columns));
  for (const auto& curve : curves) {
    Options of_one = options;
    if (curves.size() > 1) of_one.curve.file = fmt::format("{}#{}", options.curve.file, echo(curve.id));
    table.begin(curve.id);
    add_rows(of_one, curve, table);
  }
  fmt::print("{}", table.text());
}

}  // namespace bezierbench::cli
