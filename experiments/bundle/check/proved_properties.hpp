// SPDX-License-Identifier: MIT
// Whether a bundle refutes what it lists as proved.
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

  /// A line for each refuted row whose property methods.csv lists as proved at its degree; the first few.
  [[nodiscard]] std::vector<std::string> refuted() const;

 private:
  struct Refuted {
    std::string method;
    std::string property;
    std::string degree;
    std::string file;
    std::size_t line;
  };
  [[nodiscard]] bool is_proved(const Refuted& row) const;

  std::map<std::string, std::string, std::less<>> proved_;  ///< by method: "ends_exact monotone:1 ..."
  std::vector<Refuted> refuted_;
};

}  // namespace bezierbench::bundle
