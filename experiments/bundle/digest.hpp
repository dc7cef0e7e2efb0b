// SPDX-License-Identifier: MIT
// Checksums of bytes, of files as coreutils' sha256sum writes them, and of the rows of each method in each study of
// each deterministic table. The last tell where two bundles agree bit for bit; a method or column that is added later
// does not change the digests of the others.
#pragma once

#include <compare>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/schema/columns.hpp"

namespace bezierbench::bundle {

/// SHA-256 as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

/// One line as coreutils' sha256sum writes it, line end included. Throws Failure(Exit::input_output) for a name with a
/// line end or backslash, which that format would have to escape.
[[nodiscard]] std::string sha256sum_line(std::string_view name, std::string_view bytes);

/// The lines of the named files of `directory`, sorted by name as bytes. Throws Failure(Exit::input_output) where a
/// file cannot be read.
[[nodiscard]] std::string sha256sums(const std::filesystem::path& directory, std::span<const std::string> names);

// SHA256SUMS: the list of a bundle's files with their checksums.

struct Sums {
  std::map<std::string, std::string> digests;  ///< by file name
  std::vector<std::size_t> malformed;          ///< lines, from 1, that are invalid, cut, or repeat a name
};

/// Parses the text of SHA256SUMS.
[[nodiscard]] Sums parse_sums(std::string_view text);

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

/// Takes the rows of a table one by one and gives the digest of each method in each study, in the order of their first
/// rows. The digest is the SHA-256 of a CSV file with those rows in the order of the table and a header line.
class MethodDigester {
 public:
  /// `columns` are digested, in this order; `place` gives the place of a column in the rows.
  MethodDigester(const DeclaredTable& declared, const std::vector<std::string>& columns,
                 const std::function<std::size_t(std::string_view)>& place);

  void add(const std::vector<std::string>& row);
  [[nodiscard]] std::vector<MethodDigest> digests() const;

 private:
  /// The rows of one method in one study.
  struct Gathered {
    Rows rows;
    std::size_t count = 0;
    std::string text;  ///< the text that is digested
  };

  std::string table_;
  std::string header_;
  std::size_t study_;
  std::size_t method_;
  std::vector<std::size_t> places_;
  std::vector<Gathered> all_;
  std::map<Rows, std::size_t> found_;  ///< places in `all_`
};

/// The digests of a table that was read. Throws Failure(Exit::input_output) where it has not all of the columns, or
/// that of the study or the method.
[[nodiscard]] std::vector<MethodDigest> method_digests(const DeclaredTable& declared, const CsvDocument& table,
                                                       const std::vector<std::string>& columns);

/// The text of digests.csv, whose SHA-256 is the digest by which two bundles agree bit for bit or not. The digests are
/// those of all deterministic tables of a bundle, sorted by table.
[[nodiscard]] std::string digests_csv(const std::vector<MethodDigest>& digests);

/// The digests that a digests.csv states. Throws Failure(Exit::input_output) for a table without the columns, and for a
/// number of rows that is not a count.
[[nodiscard]] std::vector<MethodDigest> parse_digests(const CsvDocument& table);

}  // namespace bezierbench::bundle
