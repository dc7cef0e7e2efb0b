// SPDX-License-Identifier: MIT
#include "experiments/bundle/manifest.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "experiments/bundle/json_object.hpp"
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
    throw Failure(Exit::input_output,
                  fmt::format("{}: {}; restore the file or run again with another --out", file_name, what));
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
                  fmt::format("{}: schema_version is {}, this program reads {}; run the suite again, or use "
                              "the program of commit {}, the last that reads it",
                              file_name, version, ours, last_reader_of_earlier()));
  if (version > ours)
    throw Failure(
        Exit::input_output,
        fmt::format("{}: schema_version is {}, this program reads {}; use a newer program", file_name, version, ours));
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

}  // namespace bezierbench::bundle
