// SPDX-License-Identifier: MIT
// Digests of the rows of each method in each study of each deterministic table, which tell where two bundles agree bit
// for bit. A method or column that is added later does not change the digests of the others.
#pragma once

#include <compare>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/schema/columns.hpp"

namespace bezierbench::bundle {

inline constexpr const char* digests_name = "digests.csv";

/// Some rows of a table: those of one method in one study.
struct Rows {
  std::string table;   ///< name of the file
  std::string study;   ///< for a scorecard the printed table
  std::string method;  ///< empty for rows that belong to no method

  /// The rows as text: `accuracy.csv, study truth, method horner`.
  [[nodiscard]] std::string words() const;
  friend auto operator<=>(const Rows&, const Rows&) = default;
};

struct MethodDigest {
  Rows rows;
  std::size_t count = 0;  ///< number of rows
  std::string digest;     ///< SHA-256
  friend bool operator==(const MethodDigest&, const MethodDigest&) = default;
};

/// The digest of each method in each study, in the order of their first rows. The digest is the SHA-256 of a CSV file
/// with those rows in the order of the table, these columns in this order, and a header line. Throws
/// Failure(Exit::input_output) where the table is without one of the columns, or that of the study or the method.
[[nodiscard]] std::vector<MethodDigest> method_digests(const DeclaredTable& declared, const CsvDocument& table,
                                                       const std::vector<std::string>& columns);

/// The digests of all deterministic tables in the folder `bundle`, sorted by table, as digests.csv lists them.
/// Throws Failure(Exit::input_output) where a table cannot be read or is without a column.
[[nodiscard]] std::vector<MethodDigest> digests_of(const std::filesystem::path& bundle);
[[nodiscard]] std::string digests_csv(const std::vector<MethodDigest>& digests);

/// The digests that a digests.csv states. Throws Failure(Exit::input_output) for a table without the columns, and for a
/// number of rows that is not a count.
[[nodiscard]] std::vector<MethodDigest> parse_digests(const CsvDocument& table);

/// The digest by which two bundles agree bit for bit or not: the SHA-256 of digests.csv.
/// Throws as digests_of() does.
[[nodiscard]] std::string accuracy_digest(const std::filesystem::path& bundle);

}  // namespace bezierbench::bundle
