// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/method_digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;

/// The deterministic tables in the folder, sorted by name. An entry that cannot be read is included; reading it fails
/// later.
std::vector<std::string> deterministic_tables_in(const fs::path& bundle) {
  std::vector<std::string> present;
  for (const auto& table : declared_tables()) {
    std::error_code ignored;
    const auto type = fs::symlink_status(bundle / table.file, ignored).type();
    if (table.is_deterministic && type != fs::file_type::not_found) present.push_back(table.file);
  }
  std::ranges::sort(present);
  return present;
}

std::vector<std::size_t> places_of(const CsvDocument& table, const std::vector<std::string>& columns) {
  std::vector<std::size_t> places;
  for (const auto& name : columns) places.push_back(table.column(name));
  return places;
}

/// The rows of one method in one study.
struct Gathered {
  Rows rows;
  std::size_t count = 0;
  std::string text;  ///< the text that is digested
};

}  // namespace

std::string Rows::words() const {
  return fmt::format("{}, study {}{}{}", table, study, method.empty() ? "" : ", method ", method);
}

std::vector<MethodDigest> method_digests(const DeclaredTable& declared, const CsvDocument& table,
                                         const std::vector<std::string>& columns) {
  const auto places = places_of(table, columns);
  const auto study = table.column(declared.study);
  const auto method = table.column(declared.method);
  std::vector<Gathered> all;
  std::map<Rows, std::size_t> found;
  std::vector<std::string> fields(columns.size());
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto& from = table.row(row);
    const auto [at, is_new] = found.try_emplace({declared.file, from[study], from[method]}, all.size());
    if (is_new) all.push_back({at->first, 0, csv_line(columns)});
    std::ranges::transform(places, fields.begin(), [&](std::size_t place) { return from[place]; });
    ++all[at->second].count;
    all[at->second].text += csv_line(fields);
  }
  std::vector<MethodDigest> digests;
  for (auto& one : all) digests.push_back({std::move(one.rows), one.count, sha256_hex(one.text)});
  return digests;
}

std::vector<MethodDigest> digests_of(const fs::path& bundle) {
  std::vector<MethodDigest> all;
  for (const auto& file : deterministic_tables_in(bundle)) {
    const auto& declared = *declared_table(file);
    const auto path = bundle / file;
    std::ranges::move(method_digests(declared, parse_csv(read_bundle_file(path), path.string()), declared.digested()),
                      std::back_inserter(all));
  }
  return all;
}

std::string digests_csv(const std::vector<MethodDigest>& digests) {
  CsvTable table(declared_table(digests_name)->header());
  for (const auto& [rows, count, digest] : digests)
    table.add_row({rows.table, rows.study, rows.method, std::to_string(count), digest});
  return table.text();
}

std::vector<MethodDigest> parse_digests(const CsvDocument& table) {
  std::vector<MethodDigest> digests;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto count = number::parse_integer(table.at(row, "rows"));
    if (!count || *count < 0)
      throw Failure(Exit::input_output,
                    fmt::format("{}:{}: rows is not a count; run the suite again", table.file_name(), table.line(row)));
    digests.push_back({{table.at(row, "table"), table.at(row, "study"), table.at(row, "method")},
                       static_cast<std::size_t>(*count),
                       table.at(row, "digest")});
  }
  return digests;
}

std::string accuracy_digest(const fs::path& bundle) { return sha256_hex(digests_csv(digests_of(bundle))); }

}  // namespace bezierbench::bundle
