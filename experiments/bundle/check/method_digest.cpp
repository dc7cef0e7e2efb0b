// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/method_digest.hpp"

#include <fmt/format.h>

#include "experiments/bundle/digest.hpp"
#include "experiments/failure.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::bundle {

std::string Rows::words() const {
  return fmt::format("{}, study {}{}{}", table, study, method.empty() ? "" : ", method ", method);
}

MethodDigester::MethodDigester(const DeclaredTable& declared, const std::vector<std::string>& columns,
                               const std::function<std::size_t(std::string_view)>& place)
    : table_(declared.file),
      header_(csv_line(columns)),
      study_(place(declared.study)),
      method_(place(declared.method)) {
  for (const auto& column : columns) places_.push_back(place(column));
}

void MethodDigester::add(const std::vector<std::string>& row) {
  const auto [at, is_new] = found_.try_emplace({table_, row[study_], row[method_]}, all_.size());
  if (is_new) all_.push_back({at->first, 0, header_});
  std::vector<std::string> fields;
  for (const auto place : places_) fields.push_back(row[place]);
  ++all_[at->second].count;
  all_[at->second].text += csv_line(fields);
}

std::vector<MethodDigest> MethodDigester::digests() const {
  std::vector<MethodDigest> digests;
  for (const auto& one : all_) digests.push_back({one.rows, one.count, sha256_hex(one.text)});
  return digests;
}

std::vector<MethodDigest> method_digests(const DeclaredTable& declared, const CsvDocument& table,
                                         const std::vector<std::string>& columns) {
  MethodDigester digester(declared, columns, [&](std::string_view column) { return table.column(column); });
  for (std::size_t row = 0; row < table.row_count(); ++row) digester.add(table.row(row));
  return digester.digests();
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

}  // namespace bezierbench::bundle
