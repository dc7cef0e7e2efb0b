// SPDX-License-Identifier: MIT
// A bundle as one side of a comparison.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/bundle/check/checked_reader.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/facts.hpp"
#include "experiments/bundle/manifest.hpp"

namespace bezierbench::compare {

/// What is compared of a bundle, read at once.
struct Side {
  std::string name;  ///< as the user gave it
  bundle::Manifest manifest;
  std::vector<bundle::Fact> facts;                    ///< of machine.json, then of bundle.json
  std::map<std::string, bundle::CsvDocument> tables;  ///< timing.csv and the deterministic ones, by file name
  std::vector<std::string> damaged = {};              ///< files that are not as SHA256SUMS lists them

  /// The value of a fact; `unknown` where there is none.
  [[nodiscard]] std::string fact(std::string_view fact_name) const;
  /// The table of this name; null where the bundle has none.
  [[nodiscard]] const bundle::CsvDocument* table(const std::string& file) const;
};

inline constexpr const char* timing_file = "timing.csv";

/// Throws Failure(Exit::input_output) where `path` is no bundle or a file of it is damaged; one that reads nevertheless
/// only if damage is to be refused.
[[nodiscard]] Side read_side(const std::filesystem::path& path, bundle::Damage damage = bundle::Damage::refused);

/// A fact whose values are not the same on both sides; `unknown` where a side does not have it.
struct FactDifference {
  std::string name;
  std::string a;
  std::string b;
};

/// How the machines and the builds differ, in the order of a's facts.
[[nodiscard]] std::vector<FactDifference> fact_differences(const Side& a, const Side& b);

/// Whether both were made on the same kind of machine, as far as cpu, caches and memory say; unknown is not the same.
[[nodiscard]] bool same_machine(const Side& a, const Side& b);

}  // namespace bezierbench::compare
