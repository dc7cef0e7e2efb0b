// SPDX-License-Identifier: MIT
// A bundle as one side of a comparison.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/manifest.hpp"

namespace bezierbench::compare {

inline constexpr const char* timing_file = "timing.csv";
inline constexpr const char* cost_file = "cost.csv";

/// What is compared of a bundle, all read at once.
struct Side {
  std::string name;  ///< as the user gave it
  bundle::Manifest manifest = {};
  std::vector<bundle::Fact> facts = {};                    ///< those of machine.json, then those of bundle.json
  std::map<std::string, bundle::CsvDocument> tables = {};  ///< timing.csv, cost.csv and the deterministic tables

  /// The value of the fact `fact_name`; `unknown` where the bundle does not have it.
  [[nodiscard]] std::string fact(std::string_view fact_name) const;
  /// The table of this name; one without columns and rows where the bundle does not have it.
  [[nodiscard]] const bundle::CsvDocument& table(const std::string& file) const;
};

/// Reads the bundle in `path`. Throws Failure(Exit::input_output) where `path` is not a bundle, where a file cannot be
/// parsed or differs from its checksum.
[[nodiscard]] Side read_side(const std::filesystem::path& path);

/// A fact with different values on the two sides; the value is `unknown` where a side does not have the fact.
struct FactDifference {
  std::string name;
  std::string a;
  std::string b;
};

/// The facts in which the machines and builds differ: a's facts in their order, then those that b alone has.
[[nodiscard]] std::vector<FactDifference> fact_differences(const Side& a, const Side& b);

/// Whether both bundles come from the same kind of machine, judged by cpu, caches and memory. False where a's processor
/// is unknown.
[[nodiscard]] bool same_machine(const Side& a, const Side& b);

}  // namespace bezierbench::compare
