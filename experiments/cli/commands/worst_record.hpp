// SPDX-License-Identifier: MIT
// One row of a bundle that holds an input: of worst.csv, search.csv, guarantees.csv or guarantees_unstable.csv.
#pragma once

#include <string>
#include <string_view>

#include "experiments/bundle/check/checked_reader.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::cli {

/// A file of inputs.
struct WorstFile {
  std::string_view name;
  std::string_view id;       ///< name of the column
  std::string_view error_u;  ///< name of the column; empty where rows are about properties, not errors
};

/// A row whose fields are checked when they are used: all functions throw Failure(input_output) that names file, line
/// and column.
class WorstRecord {
 public:
  WorstRecord(bundle::CsvDocument table, std::size_t row, const WorstFile& file);

  [[nodiscard]] const std::string& text(std::string_view column) const;
  [[nodiscard]] double number(std::string_view column) const;
  [[nodiscard]] suite::ScalarKind scalar() const;
  /// The cell of the input, with curve kind, dimension and degree only: a single input does not need the other axes.
  [[nodiscard]] sample::Cell cell() const;
  [[nodiscard]] sample::Trial input(const sample::Cell& cell) const;
  [[nodiscard]] double error_u() const { return number(file_.error_u); }
  /// True for a row that says whether a method keeps a property.
  [[nodiscard]] bool is_about_property() const { return file_.error_u.empty(); }

  [[noreturn]] void malformed(std::string_view column, std::string_view what) const;

 private:
  template <class Word>
  [[nodiscard]] Word word(std::string_view column) const;
  [[nodiscard]] int count(std::string_view column, int least, int most) const;

  bundle::CsvDocument table_;
  std::size_t row_;
  WorstFile file_;
};

/// The row with this id. Throws Failure(usage) that lists the ids where there is none.
WorstRecord find_worst_record(bundle::CheckedReader& bundle, const std::string& id);

}  // namespace bezierbench::cli
