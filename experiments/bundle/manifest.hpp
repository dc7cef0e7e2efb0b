// SPDX-License-Identifier: MIT
// bundle.json: what a bundle contains, whether it is complete, and which build made it; and the reader of the JSON
// files of a bundle.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

inline constexpr std::string_view complete = "complete";
inline constexpr std::string_view partial = "partial";

struct Manifest {
  std::vector<std::string> suites;  ///< ids, in the order on the command line
  std::string suite_digest;         ///< digest of the resolved suites
  std::uint64_t seed = 0;
  std::string state;            ///< `complete` or `partial`
  std::string accuracy_digest;  ///< SHA-256 of digests.csv; filled in by BundleDirectory::finish
  std::string program_version;
  std::string git_commit;  ///< `unknown` outside a checkout
  bool git_clean = false;
  std::string fp_flags;  ///< the compiler flags for floating point

  friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// The text of bundle.json: indented, keys in a fixed order, a line end at the end; suites as `"suites": {"ids": [...],
/// "digest": "..."}`. The text follows schema/bundle.schema.json.
[[nodiscard]] std::string manifest_json(const Manifest& manifest);

/// Parses bundle.json; unknown keys are ignored. Throws Failure(Exit::input_output) with "FILE_NAME:LINE:COLUMN: ..."
/// for malformed JSON and "FILE_NAME: ..." for a key that is missing or has the wrong type, an unknown state or schema
/// version, or a seed that is not an unsigned 64-bit integer.
[[nodiscard]] Manifest parse_manifest(std::string_view text, std::string_view file_name);

/// The object that `text` holds, its keys in their order. Throws Failure(Exit::input_output): "FILE_NAME:LINE:COLUMN:
/// ..." for malformed JSON, "FILE_NAME: ..." for a value that is not an object, is nested too deep or has a number
/// beyond every double.
[[nodiscard]] nlohmann::ordered_json parse_json_object(std::string_view text, std::string_view file_name);

// The values in bundle.json and machine.json as a list that can be compared and printed.

/// One value with its path in the object: `cpu.model_name`, `load_average.0`.
struct Fact {
  std::string name;
  std::string value;  ///< the text itself; any other value as JSON

  friend bool operator==(const Fact&, const Fact&) = default;
};

/// Every value of a JSON object, in the object's order. Throws as parse_json_object does.
[[nodiscard]] std::vector<Fact> facts(std::string_view json, std::string_view file_name);

}  // namespace bezierbench::bundle
