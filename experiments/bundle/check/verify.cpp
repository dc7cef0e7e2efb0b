// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/manifest.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;
using Findings = std::vector<std::string>;

constexpr std::string_view machine_name = "machine.json";
constexpr std::string_view suite_name = "suite.toml";
constexpr std::string_view methods_name = "methods.csv";

// Files that every bundle has, whatever its suites.
constexpr std::array<std::string_view, 3> required_files{manifest_name, suite_name, machine_name};

bool contains(const auto& names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

void append(Findings& findings, const Findings& more) { findings.insert(findings.end(), more.begin(), more.end()); }

/// Calls `check`. A Failure that it throws becomes a finding.
template <class Check>
void or_finding(Findings& findings, Check check) {
  try {
    check();
  } catch (const Failure& failure) {
    findings.emplace_back(failure.what());
  }
}

class Verification {
 public:
  Verification(const fs::path& path, Folder folder) : path_(path), folder_(std::move(folder)) {}

  Findings findings(const SuiteReader& read_suites) {
    if (folder_has(suite_name)) check_suites(read_suites);
    for (const auto& name : folder_.files) check_file(name);
    check_rows();
    Findings all;
    if (folder_has(manifest_name)) try {
        check_manifest(all);
      } catch (const Failure& failure) {
        if (failure.exit() == Exit::usage)
          throw;  // a bundle of an earlier schema version, of which nothing else is known
        all.emplace_back(failure.what());
      }
    for (const std::string_view name : required_files)
      if (!folder_has(name)) add(all, name, "is missing");
    if (complete_) check_method_digests(all);
    if (folder_has(sums_name))
      check_sums(all);
    else
      add(all, sums_name, "is missing");
    append(all, suite_findings_);
    check_strays(all);
    append(all, table_findings_);
    return all;
  }

 private:
  [[nodiscard]] bool folder_has(std::string_view name) const { return contains(folder_.files, name); }
  [[nodiscard]] std::string place(std::string_view name) const { return (path_ / name).string(); }
  void add(Findings& to, std::string_view name, std::string_view what) const {
    to.push_back(fmt::format("{}: {}", place(name), what));
  }
  static bool is_known(std::string_view name) {
    return contains(required_files, name) || name == sums_name || declared_table(name) != nullptr ||
           is_curves_name(name);
  }

  void check_suites(const SuiteReader& read_suites) {
    or_finding(suite_findings_, [&] {
      const std::string text = read_bundle_file(path_ / suite_name);
      suite_digest_ = sha256_hex(text);
      expected_ = read_suites(text, place(suite_name));
    });
  }

  /// Reads a file once, for its checksum and, if it is a table, for its rows.
  void check_file(const std::string& name) {
    const std::string bytes = read_bundle_file(path_ / name);
    digests_[name] = sha256_hex(bytes);
    if (declared_table(name) != nullptr)
      or_finding(table_findings_, [&] {
        const auto table = parse_csv(bytes, place(name));
        note_method_digests(name, table);
        tables_.emplace(name, table);
      });
  }

  /// Looks at the rows of all tables: what they say, and whether their studies are those of the suites.
  void check_rows() {
    MethodFacts facts;
    if (const auto methods = tables_.find(methods_name); methods != tables_.end())
      or_finding(table_findings_, [&] { facts = method_facts(methods->second); });
    for (const auto& [name, table] : tables_) {
      or_finding(table_findings_,
                 [&, &name = name, &table = table] { append(table_findings_, row_faults(name, table, facts)); });
      if (expected_ && name != digests_name) check_studies(table);  // its rows repeat the studies of other tables
    }
  }

  void check_studies(const CsvDocument& table) {
    if (!table.has_column("study")) return;
    FewLines lines(table.file_name());
    for (std::size_t row = 0; row < table.row_count(); ++row)
      if (!contains(expected_->studies, table.at(row, "study")))
        lines.add(
            fmt::format("{}:{}: its study is not one of those of suite.toml", table.file_name(), table.line(row)));
    append(table_findings_, lines.take());
  }

  /// Keeps the digests computed from a table's rows, and those listed in digests.csv.
  void note_method_digests(std::string_view name, const CsvDocument& table) {
    if (name == digests_name) listed_ = parse_digests(table);
    const auto& declared = *declared_table(name);
    if (!declared.is_deterministic) return;
    const auto columns = declared.digested();
    if (std::ranges::all_of(columns, [&](const auto& column) { return table.has_column(column); }))
      std::ranges::move(method_digests(declared, table, columns), std::back_inserter(computed_));
  }

  /// Compares the computed digests with the listed ones. Tables were read in the order of their names, as digests.csv
  /// has them.
  void check_method_digests(Findings& all) const {
    if (!folder_has(digests_name)) return add(all, digests_name, "is missing");
    FewLines lines(place(digests_name));
    const auto differing = [&](const MethodDigest& one, const char* what) {
      lines.add(fmt::format("{}: {}: {}", place(digests_name), one.rows.words(), what));
    };
    std::map<Rows, const MethodDigest*> listed;
    for (const auto& one : listed_) listed[one.rows] = &one;
    for (const auto& one : computed_) {
      const auto found = listed.find(one.rows);
      if (found == listed.end())
        differing(one, "has no line");
      else if (*found->second != one)
        differing(one, "its rows give another digest");
      if (found != listed.end()) listed.erase(found);
    }
    for (const auto& [rows, one] : listed) differing(*one, "has no such rows");
    Findings found = lines.take();
    if (found.empty() && digests_.find(digests_name)->second != sha256_hex(digests_csv(computed_)))
      add(found, digests_name, "is not written as the tables give it");
    append(all, found);
  }

  void check_manifest(Findings& all) {
    const Manifest manifest = parse_manifest(read_bundle_file(path_ / manifest_name), place(manifest_name));
    complete_ = manifest.state == complete;
    if (!complete_) add(all, manifest_name, "state is partial; continue with `bezierbench run`");
    if (const auto digest = accuracy_digest_of_files(); digest && *digest != manifest.accuracy_digest)
      add(all, manifest_name,
          fmt::format("accuracy_digest is {}, the files give {}", manifest.accuracy_digest, *digest));
    if (suite_digest_ && *suite_digest_ != manifest.suite_digest)
      add(all, manifest_name,
          fmt::format("its digest of suites is {}, suite.toml gives {}", manifest.suite_digest, *suite_digest_));
    if (!expected_) return;
    if (expected_->seed != manifest.seed)
      add(all, manifest_name, fmt::format("seed is {}, in suite.toml {}", manifest.seed, expected_->seed));
    if (expected_->suites != manifest.suites) add(all, manifest_name, "its suites are not those of suite.toml");
  }

  /// The accuracy digest that the files give; empty for a partial bundle and without digests.csv.
  [[nodiscard]] std::optional<std::string> accuracy_digest_of_files() const {
    const auto found = digests_.find(digests_name);
    return complete_ && found != digests_.end() ? std::optional(found->second) : std::nullopt;
  }

  void check_sums(Findings& all) {
    const Sums sums = parse_sums(read_bundle_file(path_ / sums_name));
    for (const auto line : sums.malformed)
      add(all, fmt::format("{}:{}", sums_name, line), "not a line of sha256sum, or its name occurs twice");
    for (const auto& [name, digest] : sums.digests) {
      if (!folder_has(name)) {
        // Missing required files have been reported already.
        if (!contains(required_files, name)) add(all, name, "is listed in SHA256SUMS and is missing");
      } else if (digests_.at(name) != digest) {
        add(all, name, "checksum differs from SHA256SUMS");
      }
    }
    for (const std::string& name : folder_.files)
      if (name != sums_name && is_known(name) && !sums.digests.contains(name)) add(all, name, "is not in SHA256SUMS");
  }

  void check_strays(Findings& all) const {
    for (const std::string& name : folder_.files)
      if (!is_known(name)) add(all, name, "does not belong to a bundle; remove it");
    for (const std::string& name : folder_.temporaries) add(all, name, "left by an interrupted write; remove it");
    for (const std::string& name : folder_.others) {
      if (name != blocks_name || fs::is_symlink(path_ / name))
        add(all, name, "does not belong to a bundle; remove it");
      else if (complete_)
        add(all, name, "left in a complete bundle; continue with `bezierbench run` or remove it");
    }
  }

  fs::path path_;
  Folder folder_;
  bool complete_ = false;
  std::optional<Expected> expected_;
  std::optional<std::string> suite_digest_;
  std::map<std::string, std::string, std::less<>> digests_;  ///< by file name
  std::vector<MethodDigest> computed_;                       ///< from the rows of the tables
  std::vector<MethodDigest> listed_;                         ///< from digests.csv
  std::map<std::string, CsvDocument, std::less<>> tables_;   ///< those that can be read
  Findings suite_findings_;
  Findings table_findings_;
};

/// Whether the folder seems to be a damaged bundle. A single file does not suffice: any folder may have one of this
/// name.
bool looks_like_a_bundle(const Folder& folder) {
  const auto count = std::ranges::count_if(required_files, [&](auto name) { return contains(folder.files, name); });
  return contains(folder.files, manifest_name) || count + contains(folder.files, sums_name) >= 2 ||
         (count >= 1 && contains(folder.others, blocks_name));
}

bool is_innocent(const std::string& field) { return field.empty() || field == "0" || field == "yes"; }

}  // namespace

Findings verify(const fs::path& path, const SuiteReader& read_suites, bool beside_other_runs) {
  Folder folder = list_folder(path);
  if (!looks_like_a_bundle(folder))
    return {fmt::format("{}: is not a bundle; give a folder that `bezierbench run` wrote", path.string())};
  if (beside_other_runs) std::erase(folder.others, blocks_name);
  return Verification(path, std::move(folder)).findings(read_suites);
}

MethodFacts method_facts(const CsvDocument& methods_csv) {
  MethodFacts facts;
  for (std::size_t row = 0; row < methods_csv.row_count(); ++row) {
    if (!methods_csv.at(row, "bound").empty()) facts.promising.insert(methods_csv.at(row, "id"));
    if (methods_csv.at(row, "citation") == external_citation) facts.external.insert(methods_csv.at(row, "id"));
  }
  return facts;
}

std::vector<std::string> row_faults(const std::string& file, const CsvDocument& table, const MethodFacts& methods) {
  const auto& declared = *declared_table(file);
  std::vector<std::string> faults;
  FewLines lines(table.file_name());
  for (const auto& column : declared.columns) {
    if (column.accuses.empty() || !table.has_column(column.name)) continue;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
      const auto& field = table.at(row, column.name);
      if (is_innocent(field)) continue;
      if (column.is_of_promise) {
        const auto& method = table.at(row, declared.method);
        if (!methods.promising.contains(method) && !(column.is_of_external && methods.external.contains(method)))
          continue;
      }
      const auto count = field == "no" ? std::string() : field + " ";
      lines.add(fmt::format("{}:{}: {}{}", table.file_name(), table.line(row), count, column.accuses));
    }
    std::ranges::move(lines.take(), std::back_inserter(faults));
  }
  return faults;
}

}  // namespace bezierbench::bundle
