// SPDX-License-Identifier: MIT
// Checks that a bundle is intact and consistent.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::bundle {

/// What the suites of a bundle say of its other files.
struct Expected {
  std::vector<std::string> suites;  ///< their ids
  std::uint64_t seed = 0;
  std::vector<std::string> studies;  ///< their ids
};

/// Reads the text of suite.toml; the second argument is its name, for messages. Throws Failure where the text is not a
/// suite.
using SuiteReader = std::function<Expected(const std::string& text, const std::string& file_name)>;

/// What is wrong with a bundle's files, one line each, in a fixed order; empty where nothing is. Checks that
/// bundle.json can be read, is `complete` and belongs to this suite.toml; that the files are there which every bundle
/// has; every listed file, the accuracy digest, digests.csv line by line, and the checksums; that no other files or
/// folders are there; that every table is CSV; and that no row says that a bound or a promise was broken or that timed
/// output differed from the judged one, or names a study that is not in suite.toml. It finds accidents, not forgeries:
/// whoever changes rows can make their digests and checksums, too. A folder that is not a bundle gives one line that
/// says so. Throws Failure(Exit::input_output) where `path` is not a folder or a file cannot be read.
/// Blocks beside a complete bundle are a finding, unless other runs may be at work there: those tidy up in turn.
[[nodiscard]] std::vector<std::string> verify(const std::filesystem::path& path, const SuiteReader& read_suites,
                                              bool beside_other_runs = false);

/// The citation that methods.csv has for methods from outside of the program.
inline constexpr std::string_view external_citation = "external method";

/// What methods.csv states of methods.
struct MethodFacts {
  std::set<std::string, std::less<>> promising;  ///< with a bound or a promise
  std::set<std::string, std::less<>> external;
};
[[nodiscard]] MethodFacts method_facts(const CsvDocument& methods_csv);

/// The lines that tell which rows of the table `file` accuse a method, for example of broken promises.
[[nodiscard]] std::vector<std::string> row_faults(const std::string& file, const CsvDocument& table,
                                                  const MethodFacts& methods);

/// The first few findings of one kind, and how many more there are: a hostile table can have as many as it has fields.
class FewLines {
 public:
  /// `place` begins the line that counts the findings left out.
  explicit FewLines(std::string place) : place_(std::move(place)) {}

  void add(std::string line) {
    if (++count_ <= most_) lines_.push_back(std::move(line));
  }

  /// Returns all lines and forgets them.
  std::vector<std::string> take() {
    if (count_ > most_) lines_.push_back(fmt::format("{}: {} more of that kind", place_, count_ - most_));
    count_ = 0;
    return std::exchange(lines_, {});
  }

 private:
  static constexpr std::size_t most_ = 5;
  std::string place_;
  std::size_t count_ = 0;
  std::vector<std::string> lines_;
};

}  // namespace bezierbench::bundle
