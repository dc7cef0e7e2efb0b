// SPDX-License-Identifier: MIT
#include "experiments/bundle/facts.hpp"

#include <algorithm>

#include "experiments/bundle/json_object.hpp"

namespace bezierbench::bundle {

std::vector<Fact> facts(std::string_view json, std::string_view file_name) {
  std::vector<Fact> found;
  const auto flat = parse_json_object(json, file_name).flatten();
  for (const auto& [pointer, value] : flat.items()) {
    if (pointer.empty()) continue;  // flatten() gives an empty object as one null without a name
    std::string name = pointer.substr(1);
    std::ranges::replace(name, '/', '.');
    found.push_back({name, value.is_string() ? value.get<std::string>() : value.dump()});
  }
  return found;
}

}  // namespace bezierbench::bundle
