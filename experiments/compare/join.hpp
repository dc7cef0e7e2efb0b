// SPDX-License-Identifier: MIT
// Rows of two tables in pairs with the same inputs, whatever their positions.
#pragma once

#include <compare>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/manifest.hpp"
#include "experiments/bundle/schema/columns.hpp"

namespace bezierbench::compare {

/// What a row was measured or computed for (study, form, method, degree, mode, trials, ...): the key columns of its
/// table. The column of the method is called `method` here, whatever the table calls it.
class Inputs {
 public:
  Inputs() = default;

  /// The inputs of row `row` of `table`. A key column that `other` does not have is empty, as in tables of another
  /// version of the program. Numbers are compared as values: 1000000 and 1e+06 agree.
  Inputs(const bundle::DeclaredTable& declared, const bundle::CsvDocument& table, std::size_t row,
         const bundle::CsvDocument& other);

  /// The value of the input `name`; empty where the row does not have it.
  [[nodiscard]] const std::string& field(std::string_view name) const;

  /// The same inputs without the method.
  [[nodiscard]] Inputs without_method() const;

  /// The inputs that are not empty, as text: `study truth, method horner, degree 4, ...`.
  [[nodiscard]] std::string words() const;

  friend auto operator<=>(const Inputs&, const Inputs&) = default;

 private:
  using Field = std::pair<std::string, std::string>;  ///< name, and text or number in canonical spelling
  std::vector<Field> fields_;
};

/// Two rows with the same inputs, by their numbers in a and b.
struct RowPair {
  Inputs inputs;
  std::size_t a;
  std::size_t b;
};

struct Join {
  std::vector<RowPair> pairs;  ///< in a's order
  std::vector<Inputs> only_a;  ///< of the rows without a partner
  std::vector<Inputs> only_b;
};

/// Pairs the rows with the same inputs. Where inputs repeat, the first row goes with the first, the second with the
/// second, and so on.
[[nodiscard]] Join join(const bundle::DeclaredTable& declared, const bundle::CsvDocument& a,
                        const bundle::CsvDocument& b);

/// Whether both texts are numbers with the same bits, or the same text.
[[nodiscard]] bool same_value(std::string_view a, std::string_view b);

// A bundle as one side of a comparison.

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
