// SPDX-License-Identifier: MIT
// What bundle.json and machine.json say, as a list that can be compared and printed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

/// One value, by its place: `cpu.model_name`, `load_average.0`.
struct Fact {
  std::string name;
  std::string value;  ///< text as it is; anything else as JSON writes it

  friend bool operator==(const Fact&, const Fact&) = default;
};

/// Every value of a JSON object, in its order. Throws as parse_json_object.
[[nodiscard]] std::vector<Fact> facts(std::string_view json, std::string_view file_name);

}  // namespace bezierbench::bundle
