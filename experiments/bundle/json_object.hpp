// SPDX-License-Identifier: MIT
// The JSON files of a bundle, parsed with messages that name the place of an error.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

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
