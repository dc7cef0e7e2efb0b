// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/facts.hpp"
#include "experiments/bundle/folder.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view machine_name = "machine.json";

// Every bundle has them, whatever its suites.
constexpr std::array<std::string_view, 3> required_files{manifest_name, "suite.toml", machine_name};

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

class Verification {
 public:
  explicit Verification(const fs::path& path) : path_(path), folder_(list_folder(path)) {}

  std::vector<std::string> findings() {
    if (folder_has(manifest_name)) check_manifest();
    for (const std::string_view name : required_files) {
      if (!folder_has(name)) add(name, "is missing");
    }
    if (folder_has(sums_name)) {
      check_sums();
    } else {
      add(sums_name, "is missing");
    }
    if (folder_has(machine_name)) check_machine();
    check_strays();
    check_tables();
    return std::move(findings_);
  }

 private:
  [[nodiscard]] bool folder_has(std::string_view name) const { return contains(folder_.files, name); }

  void add(std::string_view name, std::string_view what) {
    findings_.push_back(fmt::format("{}: {}", (path_ / name).string(), what));
  }

  void check_manifest() {
    try {
      const Manifest manifest = BundleDirectory::open(path_).manifest();
      complete_ = manifest.state == complete;
      if (!complete_) add(manifest_name, "state is partial; continue with bezierbench run");
      if (const std::string digest = accuracy_digest(path_); digest != manifest.accuracy_digest) {
        add(manifest_name, fmt::format("accuracy_digest is {}, the files give {}", manifest.accuracy_digest, digest));
      }
    } catch (const Failure& failure) {
      findings_.emplace_back(failure.what());
    }
  }

  void check_machine() {
    try {
      (void)facts(read_file(path_ / machine_name), (path_ / machine_name).string());
    } catch (const Failure& failure) {
      findings_.emplace_back(failure.what());
    }
  }

  // Name and digest of one line of sha256sum, text or binary mode; nothing where it is not one.
  static std::optional<std::pair<std::string, std::string>> parse_line(std::string_view line) {
    constexpr std::size_t digits = 64;
    if (line.size() < digits + 3) return std::nullopt;
    const std::string_view digest = line.substr(0, digits);
    if (digest.find_first_not_of("0123456789abcdef") != std::string_view::npos) return std::nullopt;
    const std::string_view mode = line.substr(digits, 2);
    if (mode != "  " && mode != " *") return std::nullopt;
    return std::pair(std::string(line.substr(digits + 2)), std::string(digest));
  }

  void read_sums() {
    const std::string text = read_file(path_ / sums_name);
    std::string_view rest = text;
    for (std::size_t line = 1; !rest.empty(); ++line) {
      const std::size_t end = rest.find('\n');
      const auto entry = parse_line(rest.substr(0, end));
      // A missing line end means a cut file, even where the rest of the line happens to read.
      if (!entry || end == std::string_view::npos || !sums_.insert(*entry).second) {
        add(fmt::format("{}:{}", sums_name, line), "not a line of sha256sum, or its name occurs twice");
      }
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
  }

  void check_sums() {
    read_sums();
    for (const auto& [name, digest] : sums_) {
      if (!folder_has(name)) {
        // Required ones were named already.
        if (std::ranges::find(required_files, name) == required_files.end()) add(name, "is missing");
      } else if (sha256_hex(read_file(path_ / name)) != digest) {
        add(name, "checksum differs from SHA256SUMS");
      }
    }
    for (const std::string& name : folder_.files) {
      if (name != sums_name && !sums_.contains(name)) add(name, "is not in SHA256SUMS");
    }
  }

  void check_strays() {
    for (const std::string& name : folder_.temporaries) add(name, "left by an interrupted write; remove it");
    for (const std::string& name : folder_.others) {
      if (name != blocks_name) {
        add(name, "does not belong to a bundle; remove it");
      } else if (complete_) {
        add(name, "left in a complete bundle; continue with bezierbench run or remove it");
      }
    }
  }

  void check_tables() {
    for (const std::string& name : folder_.files) {
      if (!name.ends_with(".csv")) continue;
      const std::string text = read_file(path_ / name);
      try {
        check_bounds(parse_csv(text, (path_ / name).string()));
      } catch (const Failure& failure) {
        findings_.emplace_back(failure.what());
      }
    }
  }

  /// A row that broke a proved bound is a finding, in whichever table it stands.
  void check_bounds(const CsvDocument& table) {
    constexpr std::string_view column = "bound_violations";
    if (!table.has_column(column)) return;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
      const std::string& count = table.at(row, column);
      if (count.empty() || count == "0") continue;
      findings_.push_back(fmt::format("{}:{}: {} bound violations", table.file_name(), table.line(row), count));
    }
  }

  fs::path path_;
  Folder folder_;
  bool complete_ = false;
  std::map<std::string, std::string> sums_;
  std::vector<std::string> findings_;
};

}  // namespace

std::vector<std::string> verify(const fs::path& path) { return Verification(path).findings(); }

}  // namespace bezierbench::bundle
