// SPDX-License-Identifier: MIT
#include "experiments/bundle/digest.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/failure.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::bundle {

std::string sha256_hex(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL refuses to compute SHA-256");
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

std::string sha256sum_line(std::string_view name, std::string_view bytes) {
  if (name.find_first_of("\\\r\n") != std::string_view::npos) {
    std::string printable(name);
    std::ranges::replace_if(
        printable, [](char c) { return c == '\r' || c == '\n'; }, '?');  // a message is one line
    throw Failure(Exit::input_output, printable + ": line end or backslash in a file name; rename the file");
  }
  return fmt::format("{}  {}\n", sha256_hex(bytes), name);
}

std::string sha256sums(const std::filesystem::path& directory, std::span<const std::string> names) {
  std::vector<std::string> sorted(names.begin(), names.end());
  std::ranges::sort(sorted);
  std::string lines;
  for (const std::string& name : sorted) lines += sha256sum_line(name, read_bundle_file(directory / name));
  return lines;
}

namespace {

// Name and digest in one line of sha256sum, text or binary mode; empty for any other line.
std::optional<std::pair<std::string, std::string>> parse_line(std::string_view line) {
  constexpr std::size_t digits = 64;
  if (line.size() < digits + 3) return std::nullopt;
  const std::string_view digest = line.substr(0, digits);
  if (digest.find_first_not_of("0123456789abcdef") != std::string_view::npos) return std::nullopt;
  const std::string_view mode = line.substr(digits, 2);
  if (mode != "  " && mode != " *") return std::nullopt;
  return std::pair(std::string(line.substr(digits + 2)), std::string(digest));
}

}  // namespace

Sums parse_sums(std::string_view text) {
  Sums sums;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    const auto entry = parse_line(text.substr(0, end));
    // A missing line end means that the file was cut, even if the rest of the line can be read.
    if (!entry || end == std::string_view::npos || !sums.digests.insert(*entry).second) sums.malformed.push_back(line);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return sums;
}

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
      throw Failure(Exit::input_output, "{}:{}: rows is not a count; run the suite again", table.file_name(),
                    table.line(row));
    digests.push_back({{table.at(row, "table"), table.at(row, "study"), table.at(row, "method")},
                       static_cast<std::size_t>(*count),
                       table.at(row, "digest")});
  }
  return digests;
}

}  // namespace bezierbench::bundle
