// SPDX-License-Identifier: MIT
#include "experiments/bundle/manifest.hpp"

#include <fmt/format.h>

#include <concepts>
#include <nlohmann/json.hpp>

#include "experiments/bundle/json_object.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

using Json = nlohmann::ordered_json;

// Reads typed values out of one object. Errors name the file and the key.
class Keys {
 public:
  Keys(const Json& object, std::string_view file_name) : object_(object), file_name_(file_name) {}

  [[noreturn]] void fail(std::string_view what) const {
    throw Failure(Exit::input_output,
                  fmt::format("{}: {}; restore the file or run again with another --out", file_name_, what));
  }

  [[nodiscard]] const Json& value(const char* key) const {
    const auto found = object_.find(key);
    if (found == object_.end()) fail(fmt::format("key '{}' is missing", key));
    return *found;
  }

  /// A value that JSON converts to this type. `must_be` says which, for the message.
  template <class Value>
  [[nodiscard]] Value get(const char* key, std::string_view must_be) const {
    const Json& found = value(key);
    // JSON integers beyond 64 bits are parsed as floating point and negative ones as signed: both are refused here.
    if constexpr (std::same_as<Value, std::uint64_t>)
      if (!found.is_number_unsigned()) fail(fmt::format("'{}' must be {}", key, must_be));
    try {
      return found.get<Value>();
    } catch (const Json::type_error&) {
      fail(fmt::format("'{}' must be {}", key, must_be));
    }
  }
  [[nodiscard]] std::string text(const char* key) const { return get<std::string>(key, "a string"); }
  [[nodiscard]] std::uint64_t unsigned_integer(const char* key) const {
    return get<std::uint64_t>(key, "an unsigned 64-bit integer");
  }

 private:
  const Json& object_;
  std::string_view file_name_;
};

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
  const Keys keys(json, file_name);
  const auto version = keys.unsigned_integer("schema_version");
  const auto ours = static_cast<std::uint64_t>(written_version());
  if (version < ours)
    throw Failure(Exit::usage,
                  fmt::format("{}: schema_version is {}, this program reads {}; run the suite again, or use "
                              "the program of commit {}, the last that reads it",
                              file_name, version, ours, last_reader_of_earlier()));
  if (version > ours)
    throw Failure(
        Exit::input_output,
        fmt::format("{}: schema_version is {}, this program reads {}; use a newer program", file_name, version, ours));
  const Json& suites = keys.value("suites");
  if (!suites.is_object()) keys.fail("'suites' must be an object");
  const Keys suite_keys(suites, file_name);

  Manifest manifest;
  manifest.suites = suite_keys.get<std::vector<std::string>>("ids", "an array of strings");
  manifest.suite_digest = suite_keys.text("digest");
  manifest.seed = keys.unsigned_integer("seed");
  manifest.state = keys.text("state");
  if (manifest.state != complete && manifest.state != partial) keys.fail("'state' must be complete or partial");
  manifest.accuracy_digest = keys.text("accuracy_digest");
  manifest.program_version = keys.text("program_version");
  manifest.git_commit = keys.text("git_commit");
  manifest.git_clean = keys.get<bool>("git_clean", "true or false");
  manifest.fp_flags = keys.text("fp_flags");
  return manifest;
}

}  // namespace bezierbench::bundle
