// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/coverage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

#include "experiments/bundle/check/few_lines.hpp"
#include "experiments/bundle/schema/columns.hpp"

namespace bezierbench::bundle {
namespace {

using Findings = std::vector<std::string>;
using Fields = std::vector<std::string>;

Fields fields_of(const CsvDocument& table, std::size_t row, const Fields& columns) {
  Fields fields;
  for (const auto& column : columns) fields.push_back(table.at(row, column));
  return fields;
}

/// The declared key columns that all of `tables` have.
Fields keys_of(const DeclaredTable& declared, std::initializer_list<const CsvDocument*> tables) {
  Fields keys;
  for (const auto& column : declared.columns)
    if (column.is_key && std::ranges::all_of(tables, [&](const auto* table) { return table->has_column(column.name); }))
      keys.push_back(column.name);
  return keys;
}

/// `study a, method direct, degree 3`
std::string words(const Fields& keys, const Fields& fields) {
  Fields all;
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (!fields[k].empty()) all.push_back(fmt::format("{} {}", keys[k], fields[k]));
  return fmt::format("{}", fmt::join(all, ", "));
}

/// The steps of a chain of conversions; any other id is one.
Fields steps_of(std::string_view method) {
  Fields steps;
  for (std::size_t begin = 0; begin <= method.size();) {
    const auto end = std::min(method.find('+', begin), method.size());
    steps.emplace_back(method.substr(begin, end - begin));
    begin = end + 1;
  }
  return steps;
}

/// What two builds say of their methods.
class MethodLists {
 public:
  MethodLists(const CsvDocument& ours, const CsvDocument& theirs) {
    const auto keys = keys_of(*declared_table(methods_name), {&ours, &theirs});
    Fields columns;
    std::ranges::copy_if(ours.header(), std::back_inserter(columns),
                         [&](const auto& c) { return theirs.has_column(c); });
    std::map<Fields, Fields> listed;
    for (std::size_t row = 0; row < theirs.row_count(); ++row) {
      listed[fields_of(theirs, row, keys)] = fields_of(theirs, row, columns);
      listed_.insert(theirs.at(row, "id"));
    }
    for (std::size_t row = 0; row < ours.row_count(); ++row) {
      const auto& id = ours.at(row, "id");
      ours_.insert(id);
      const auto key = fields_of(ours, row, keys);
      const auto found = listed.find(key);
      if (found != listed.end() && found->second == fields_of(ours, row, columns)) continue;
      other_.insert(id);
      // Another build of the same commit may have other libraries, but not fewer methods of our own.
      if (found != listed.end() || !id.starts_with("peer_"))
        differences_.push_back(fmt::format("{} {} this program, which is of the same commit", words(keys, key),
                                           found == listed.end() ? "is missing, unlike in" : "is not described as by"));
    }
  }

  /// Whether a row of the method must be as this build plans it. A row of something else, such as the sentinel, must.
  [[nodiscard]] bool is_ours(std::string_view method) const {
    return std::ranges::none_of(steps_of(method), [&](const auto& step) { return other_.contains(step); });
  }
  /// Whether the bundle lists the method.
  [[nodiscard]] bool is_listed(std::string_view method) const {
    return std::ranges::all_of(steps_of(method), [&](const auto& step) { return listed_.contains(step); });
  }
  /// Whether this build has the method.
  [[nodiscard]] bool is_known(std::string_view method) const {
    return std::ranges::all_of(steps_of(method), [&](const auto& step) { return ours_.contains(step); });
  }
  [[nodiscard]] const Findings& differences() const { return differences_; }

 private:
  std::set<std::string, std::less<>> ours_;
  std::set<std::string, std::less<>> listed_;
  std::set<std::string, std::less<>> other_;  ///< methods of ours that the bundle lists otherwise or not
  Findings differences_;
};

/// The method of a row: of a table without a column of them, the empty one. A table outside the digests declares none.
std::string method_of(const DeclaredTable& declared, const CsvDocument& table, std::size_t row) {
  const std::string column = declared.method.empty() ? "method" : declared.method;
  return table.has_column(column) ? table.at(row, column) : std::string();
}

/// Compares the rows of one table, which may be missing, with those that are planned. Of another build the table may lack
/// what no method has there: studies may have learnt to ask more.
Findings table_faults_of(const DeclaredTable& declared, const CsvDocument& planned, const CsvDocument* table,
                         const MethodLists& methods, std::set<std::string, std::less<>> external,
                         bool is_of_other_build, const std::string& place) {
  auto keys = table == nullptr ? keys_of(declared, {&planned}) : keys_of(declared, {&planned, table});
  std::erase_if(keys, [&](const auto& key) { return declared.column(key)->is_of_machine; });
  std::set<Fields> all;
  std::set<Fields> missing;
  std::set<std::string, std::less<>> studies;
  for (std::size_t row = 0; row < planned.row_count(); ++row) {
    studies.insert(planned.at(row, declared.study));
    external.erase(method_of(declared, planned, row));  // what is planned of it is all that it has here
    const auto key = fields_of(planned, row, keys);
    all.insert(key);
    if (methods.is_ours(method_of(declared, planned, row))) missing.insert(key);
  }
  const auto cell_of = [&](Fields key) {
    const auto method = std::ranges::find(keys, declared.method);
    if (method != keys.end()) key.erase(key.begin() + (method - keys.begin()));
    return key;
  };
  std::set<Fields> cells;
  FewLines foreign(place);
  for (std::size_t row = 0; table != nullptr && row < table->row_count(); ++row) {
    if (!studies.contains(table->at(row, declared.study))) continue;
    const auto key = fields_of(*table, row, keys);
    missing.erase(key);
    cells.insert(cell_of(key));
    const auto method = method_of(declared, *table, row);
    const bool is_unlisted = !methods.is_listed(method) && methods.is_known(method);
    // Of another build, which may have more of the method's rows.
    const bool is_foreign = methods.is_listed(method) && !(methods.is_known(method) && methods.is_ours(method));
    if (is_unlisted)
      foreign.add(fmt::format("{}:{}: {} does not list its method {}", place, table->line(row), methods_name, method));
    else if (!all.contains(key) && !is_foreign && !external.contains(method))
      foreign.add(fmt::format("{}:{}: suite.toml asks for no row with {}", place, table->line(row), words(keys, key)));
  }
  if (is_of_other_build) std::erase_if(missing, [&](const auto& key) { return !cells.contains(cell_of(key)); });
  FewLines lines(place);
  for (const auto& key : missing)
    lines.add(fmt::format("{}: the row with {} is missing, suite.toml asks for it", place, words(keys, key)));
  auto findings = foreign.take();
  std::ranges::move(lines.take(), std::back_inserter(findings));
  return findings;
}

/// Finds where a table that declares `for_each` does not have one row for each of those rows.
Findings unpaired_rows(const TablesByName& tables, const std::string& place) {
  Findings findings;
  for (const auto& declared : declared_tables()) {
    if (!declared.for_each) continue;
    const auto found = tables.find(declared.for_each->table);
    if (found == tables.end()) continue;
    const auto& from = found->second;
    const auto keys = keys_of(declared, {&from});
    std::set<Fields> wanted;
    for (std::size_t row = 0; row < from.row_count(); ++row)
      if (!from.at(row, declared.for_each->filled).empty() &&
          std::ranges::all_of(declared.for_each->where,
                              [&](const auto& one) { return from.at(row, one.first) == one.second; }))
        wanted.insert(fields_of(from, row, keys));
    FewLines lines(fmt::format("{}/{}", place, declared.file));
    if (const auto own = tables.find(declared.file); own != tables.end())
      for (std::size_t row = 0; row < own->second.row_count(); ++row)
        if (wanted.erase(fields_of(own->second, row, keys)) == 0)
          lines.add(fmt::format("{}:{}: there is no such row in {}", own->second.file_name(), own->second.line(row),
                                declared.for_each->table));
    for (const auto& key : wanted)
      lines.add(fmt::format("{}/{}: the row with {} is missing, {} has it", place, declared.file, words(keys, key),
                            declared.for_each->table));
    std::ranges::move(lines.take(), std::back_inserter(findings));
  }
  return findings;
}

}  // namespace

Findings coverage_faults(const Plan& plan, const TablesByName& tables, const std::string& git_commit,
                         const std::string& place) {
  const auto listed = tables.find(methods_name);
  if (listed == tables.end() || plan.methods_csv.empty()) return {};
  const MethodLists methods(parse_csv(plan.methods_csv, methods_name), listed->second);
  Findings findings;
  const bool are_known = git_commit != "unknown" && plan.git_commit != "unknown";
  if (are_known && git_commit == plan.git_commit) {
    FewLines lines(listed->second.file_name());
    for (const auto& one : methods.differences()) lines.add(fmt::format("{}: {}", listed->second.file_name(), one));
    findings = lines.take();
  }
  for (const auto& [file, planned] : plan.rows) {
    const auto found = tables.find(file);
    std::ranges::move(
        table_faults_of(*declared_table(file), planned, found == tables.end() ? nullptr : &found->second, methods,
                        plan.external, are_known && git_commit != plan.git_commit, place + "/" + file),
        std::back_inserter(findings));
  }
  std::ranges::move(unpaired_rows(tables, place), std::back_inserter(findings));
  return findings;
}

Findings repeated_rows(const std::string& file, const CsvDocument& table) {
  const auto& declared = *declared_table(file);
  const auto keys = keys_of(declared, {&table});
  if (keys.empty() || keys != keys_of(declared, {})) return {};  // an older version has fewer
  std::map<Fields, std::size_t> lines;
  FewLines findings(table.file_name());
  for (std::size_t row = 0; row < table.row_count(); ++row)
    if (const auto [first, is_new] = lines.try_emplace(fields_of(table, row, keys), table.line(row)); !is_new)
      findings.add(fmt::format("{}:{}: repeats the row of line {}", table.file_name(), table.line(row), first->second));
  return findings.take();
}

}  // namespace bezierbench::bundle
