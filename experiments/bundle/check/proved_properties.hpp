// SPDX-License-Identifier: MIT
// Whether the verdicts of a bundle on properties of methods are those that its other fields give.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::bundle {

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

}  // namespace bezierbench::bundle
