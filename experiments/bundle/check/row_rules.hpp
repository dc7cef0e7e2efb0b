// SPDX-License-Identifier: MIT
// What the rows of a table say against themselves or a method, by the rules of tables.schema.json.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::bundle {

/// The methods for which methods.csv states a bound or a promise.
[[nodiscard]] std::set<std::string, std::less<>> promising_methods(const CsvDocument& methods_csv);

/// The lines that tell which rows of the table `file` accuse a method, for example of broken promises, and in which rows
/// statistics are not in their order, for example a mean above the maximum. `promising` are the methods that promise
/// something.
[[nodiscard]] std::vector<std::string> row_faults(const std::string& file, const CsvDocument& table,
                                                  const std::set<std::string, std::less<>>& promising);

// Whether the verdicts of a bundle on properties of methods are those that its other fields give.

/// Reads the tables of a bundle in any order; others than methods.csv, guarantees.csv and guarantees_unstable.csv are
/// ignored, and so are rows without the fields that it needs, which the schema reports.
class ProvedProperties {
 public:
  void read(std::string_view file, const CsvDocument& table);

  /// A line for each row whose verdict contradicts methods.csv or its own count of inputs that break the property; the
  /// first few.
  [[nodiscard]] std::vector<std::string> faults() const;

 private:
  struct Tried {
    std::string method;
    std::string property;
    std::string degree;
    std::string verdict;
    std::string broken;
    std::string file;
    std::size_t line;
  };
  [[nodiscard]] bool is_proved(const Tried& row) const;
  [[nodiscard]] std::string fault(const Tried& row) const;

  std::map<std::string, std::string, std::less<>> proved_;  ///< by method: "ends_exact monotone:1 ..."
  std::vector<Tried> tried_;
};

// How many of a bundle's accuracy results come from the same kernels that are timed.

/// Counts of evaluations in accuracy studies; one evaluation is one method in one trial. Groups of trials may be
/// evaluated by another kernel, which is compared bit for bit with the method's own from time to time.
struct KernelShare {
  std::uint64_t judged = 0;
  std::uint64_t own = 0;  ///< by the kernel that is timed, alone or beside that of a group
};

/// The counts in reference.csv. Empty for a bundle without accuracy studies, and for one of an older program that did
/// not count. Throws Failure(Exit::input_output) for a table that cannot be read or a field that is not a count.
[[nodiscard]] std::optional<KernelShare> kernel_share(const std::filesystem::path& path);

}  // namespace bezierbench::bundle
