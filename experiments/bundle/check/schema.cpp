// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "experiments/bundle/json_object.hpp"
#include "experiments/failure.hpp"
#include "schemas.hpp"

namespace bezierbench::bundle {
namespace {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// The place of an error, `cpu.smt`; the library gives `<root>`, `["cpu"]` and `["smt"]`.
std::string place_of(const valijson::ValidationResults::Error& error) {
  std::string place;
  for (auto step : error.context) {
    std::erase_if(step, [](char c) { return c == '[' || c == ']' || c == '"'; });
    if (step != "<root>") place += (place.empty() ? "" : ".") + step;
  }
  return place;
}

std::optional<std::string> fault(std::string_view schema_text, std::string_view text,
                                 const std::string& file_name) try {
  valijson::Schema schema;
  const auto declared = nlohmann::json::parse(schema_text);
  valijson::SchemaParser().populateSchema(Adapter(declared), schema);
  const nlohmann::json document = parse_json_object(text, file_name);
  valijson::ValidationResults results;
  if (valijson::Validator().validate(schema, Adapter(document), &results)) return std::nullopt;
  valijson::ValidationResults::Error first;
  results.popError(first);
  const auto place = place_of(first);
  return fmt::format("{}: {}{}{}", file_name, place, place.empty() ? "" : ": ", first.description);
} catch (const Failure& failure) {
  return failure.what();
}

}  // namespace

std::optional<std::string> manifest_fault(std::string_view text, const std::string& file_name) {
  return fault(manifest_schema_text, text, file_name);
}

std::optional<std::string> machine_fault(std::string_view text, const std::string& file_name) {
  return fault(machine_schema_text, text, file_name);
}

}  // namespace bezierbench::bundle
