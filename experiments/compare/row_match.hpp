// SPDX-License-Identifier: MIT
// Which rows of two tables are about the same thing: those whose inputs agree, wherever they stand.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/schema/columns.hpp"

namespace bezierbench::compare {

/// What a row was measured or computed for: study, curve, method, degree, mode, trials, ...: the key columns of its
/// table. The column of the method is called `method`, whatever it is called in the table.
class Inputs {
 public:
  Inputs() = default;

  /// Of one row, as far as both tables have the column: one of an older program may lack it. Numbers are taken as
  /// values, so that 1000000 and 1e+06 agree.
  Inputs(const bundle::DeclaredTable& declared, const bundle::CsvDocument& table, std::size_t row,
         const bundle::CsvDocument& other);

  /// Empty where the row has none. Throws std::invalid_argument for what is a key of no table.
  [[nodiscard]] const std::string& field(std::string_view name) const;

  /// The same inputs whatever the method.
  [[nodiscard]] Inputs without_method() const;

  /// `study truth, method horner, degree 4, ...`: the fields that are there.
  [[nodiscard]] std::string words() const;

  friend auto operator<=>(const Inputs&, const Inputs&) = default;

 private:
  using Field = std::pair<std::string, std::string>;  ///< name, and text or canonical number
  std::vector<Field> fields_;
};

/// Two rows with the same inputs.
struct RowPair {
  Inputs inputs;
  std::size_t a;
  std::size_t b;
};

struct RowMatch {
  std::vector<RowPair> pairs;  ///< in a's order
  std::size_t only_a = 0;
  std::size_t only_b = 0;
};

/// Of rows that repeat the same inputs the first goes with the first, and so on.
[[nodiscard]] RowMatch match_rows(const bundle::DeclaredTable& declared, const bundle::CsvDocument& a,
                                  const bundle::CsvDocument& b);

/// Columns that both have and that hold results: those that are digested and are no keys. In the order of the schema.
[[nodiscard]] std::vector<std::string> result_columns(const bundle::DeclaredTable& declared,
                                                      const bundle::CsvDocument& a, const bundle::CsvDocument& b);

/// The same double to the last bit where both are numbers, else the same text.
[[nodiscard]] bool same_value(std::string_view a, std::string_view b);

}  // namespace bezierbench::compare
