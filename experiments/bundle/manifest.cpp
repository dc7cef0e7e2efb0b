// SPDX-License-Identifier: MIT
#include "experiments/bundle/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/bundle/schema/columns.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string manifest_json(const Manifest& manifest) {
  Json json;
  json["schema_version"] = written_version();
  json["suites"] = {{"ids", manifest.suites}, {"digest", manifest.suite_digest}};
  json["seed"] = manifest.seed;
  json["state"] = manifest.state;
  json["accuracy_digest"] = manifest.accuracy_digest;
  json["program_version"] = manifest.program_version;
  json["git_commit"] = manifest.git_commit;
  json["git_clean"] = manifest.git_clean;
  json["fp_flags"] = manifest.fp_flags;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Manifest parse_manifest(std::string_view text, std::string_view file_name) {
  const Json json = parse_json_object(text, file_name);
  const auto fail = [&](const std::string& what) {
    throw Failure(Exit::input_output, "{}: {}; restore the file or run again with another --out", file_name, what);
  };
  const auto read = [&](const Json& from, const char* key, auto& value) {
    try {
      from.at(key).get_to(value);
    } catch (const Json::exception&) {
      fail(fmt::format("'{}' is missing or of another type", key));
    }
  };
  int version = 0;
  read(json, "schema_version", version);
  const int ours = written_version();
  if (version < ours)
    throw Failure(Exit::usage,
                  "{}: schema_version is {}, this program reads {}; run the suite again, or use the program of commit "
                  "{}, the last that reads it",
                  file_name, version, ours, last_reader_of_earlier());
  if (version > ours)
    throw Failure(Exit::input_output, "{}: schema_version is {}, this program reads {}; use a newer program", file_name,
                  version, ours);
  Manifest manifest;
  Json suites;
  read(json, "suites", suites);
  read(suites, "ids", manifest.suites);
  read(suites, "digest", manifest.suite_digest);
  read(json, "seed", manifest.seed);
  read(json, "state", manifest.state);
  if (manifest.state != complete && manifest.state != partial) fail("'state' must be complete or partial");
  read(json, "accuracy_digest", manifest.accuracy_digest);
  read(json, "program_version", manifest.program_version);
  read(json, "git_commit", manifest.git_commit);
  read(json, "git_clean", manifest.git_clean);
  read(json, "fp_flags", manifest.fp_flags);
  return manifest;
}

nlohmann::ordered_json parse_json_object(std::string_view text, std::string_view file_name) {
  using Json = nlohmann::ordered_json;
  constexpr std::string_view advice = "restore the file or run again with another --out";
  // JSON is destroyed and written by recursion, so that its depth must have a limit.
  constexpr int deepest = 100;
  const auto not_too_deep = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth <= deepest) return true;
    throw Failure(Exit::input_output, "{}: nested more than {} deep; {}", file_name, deepest, advice);
  };
  try {
    Json object = Json::parse(text, not_too_deep);
    if (!object.is_object()) throw Failure(Exit::input_output, "{}: not a JSON object; {}", file_name, advice);
    return object;
  } catch (const Json::parse_error& error) {
    const std::string_view before = text.substr(0, error.byte == 0 ? 0 : error.byte - 1);
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0: the first line
    throw Failure(Exit::input_output, "{}:{}:{}: malformed JSON; {}", file_name, line, column, advice);
  } catch (const Json::out_of_range&) {
    throw Failure(Exit::input_output, "{}: a number beyond every double; {}", file_name, advice);
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
