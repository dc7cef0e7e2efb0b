// SPDX-License-Identifier: MIT
#include "experiments/bundle/json_object.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/failure.hpp"

namespace bezierbench::bundle {

nlohmann::ordered_json parse_json_object(std::string_view text, std::string_view file_name) {
  using Json = nlohmann::ordered_json;
  constexpr std::string_view advice = "restore the file or run again with another --out";
  // JSON is destroyed and written by recursion, so that its depth must have a limit.
  constexpr int deepest = 100;
  const auto not_too_deep = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth <= deepest) return true;
    throw Failure(Exit::input_output, fmt::format("{}: nested more than {} deep; {}", file_name, deepest, advice));
  };
  try {
    Json object = Json::parse(text, not_too_deep);
    if (!object.is_object())
      throw Failure(Exit::input_output, fmt::format("{}: not a JSON object; {}", file_name, advice));
    return object;
  } catch (const Json::parse_error& error) {
    const std::string_view before = text.substr(0, error.byte == 0 ? 0 : error.byte - 1);
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0: the first line
    throw Failure(Exit::input_output, fmt::format("{}:{}:{}: malformed JSON; {}", file_name, line, column, advice));
  } catch (const Json::out_of_range&) {
    throw Failure(Exit::input_output, fmt::format("{}: a number beyond every double; {}", file_name, advice));
  }
}

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
