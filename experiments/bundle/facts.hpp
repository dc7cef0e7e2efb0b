// SPDX-License-Identifier: MIT
// The values in bundle.json and machine.json as a list that can be compared and printed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

/// One value with its path in the object: `cpu.model_name`, `load_average.0`.
struct Fact {
  std::string name;
  std::string value;  ///< the text itself; any other value as JSON

  friend bool operator==(const Fact&, const Fact&) = default;
};

/// Every value of a JSON object, in the object's order. Throws as parse_json_object does.
[[nodiscard]] std::vector<Fact> facts(std::string_view json, std::string_view file_name);

}  // namespace bezierbench::bundle
