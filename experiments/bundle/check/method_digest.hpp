// SPDX-License-Identifier: MIT
// Which methods of which studies agree bit for bit in two bundles: a digest for each of them in each deterministic
// table. Methods and columns that are added later change no digest of those that were there.
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
  std::string table;   ///< the file
  std::string study;   ///< of a scorecard the printed table
  std::string method;  ///< empty for rows that are no method's

  /// `accuracy.csv, study truth, method horner`.
  [[nodiscard]] std::string words() const;
  friend auto operator<=>(const Rows&, const Rows&) = default;
};

struct MethodDigest {
  Rows rows;
  std::size_t count = 0;  ///< of the rows
  std::string digest;     ///< SHA-256
  friend bool operator==(const MethodDigest&, const MethodDigest&) = default;
};

/// For each method in each study, in the order of their first rows. The digest is the SHA-256 of a CSV file with those
/// rows, in the order of the table, and these columns, in this order, under a header line of their names. Throws
/// Failure(Exit::input_output) where the table lacks one of them, or that of the study or the method.
[[nodiscard]] std::vector<MethodDigest> method_digests(const DeclaredTable& declared, const CsvDocument& table,
                                                       const std::vector<std::string>& columns);

/// digests.csv, as the deterministic tables that are in the folder of a bundle of this schema version give it: sorted
/// by table. Throws Failure(Exit::input_output) where a table cannot be read or lacks a column.
[[nodiscard]] std::vector<MethodDigest> digests_of(const std::filesystem::path& bundle, int version);
[[nodiscard]] std::string digests_csv(const std::vector<MethodDigest>& digests);

/// The digests that a digests.csv states. Throws Failure(Exit::input_output) for a table without the columns or a wrong count of rows.
[[nodiscard]] std::vector<MethodDigest> parse_digests(const CsvDocument& table);

/// Says whether two bundles agree bit for bit: the SHA-256 of digests.csv. In schema version 1 that of the sha256sum
/// lines of the deterministic tables, sorted by name. Throws as digests_of().
[[nodiscard]] std::string accuracy_digest(const std::filesystem::path& bundle, int version);

}  // namespace bezierbench::bundle
