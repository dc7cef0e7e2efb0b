// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <variant>
#include <vector>

#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/failure.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/nearest.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {
namespace {

using Json = nlohmann::ordered_json;
using suite::Field;
using suite::Kind;

constexpr std::size_t columns = 80;

template <class Enum>
std::string words_of() {
  return fmt::format("{}", fmt::join(suite::all_words<Enum>(), ", "));
}

/// A description of the values that may be written, by the type of the slot that a field points to.
struct TypeText {
  std::string operator()(const suite::Kind* const* /*type*/) const { return "the id of a kind"; }
  std::string operator()(const std::string* /*type*/) const { return "a string"; }
  template <suite::Worded Enum>
  std::string operator()(const Enum* /*type*/) const {
    return "one of " + words_of<Enum>();
  }
  std::string operator()(const std::int64_t* /*type*/) const { return "a whole number"; }
  std::string operator()(const std::vector<int>* /*type*/) const { return "whole numbers"; }
  std::string operator()(const std::vector<double>* /*type*/) const { return "numbers"; }
  std::string operator()(const std::vector<suite::Interval>* /*type*/) const { return "pairs of numbers"; }
  std::string operator()(const std::vector<std::string>* /*type*/) const { return "strings"; }
  template <suite::Worded Enum>
  std::string operator()(const std::vector<Enum>* /*type*/) const {
    return "some of " + words_of<Enum>();
  }
};

/// A study with the defaults of its kind only.
suite::Study default_study(const Kind& kind) {
  suite::Study study;
  study.kind = &kind;
  return study;
}

std::string example_of(const Kind& kind, const Field& field) {
  if (field.key == "kind") return fmt::format("\"{}\"", kind.id);
  return std::string(field.key == "methods" ? kind.methods_example : field.example);
}

std::string default_of(const Kind& kind, const Field& field) {
  if (suite::is_required(kind, field))
    return field.key == "degree" && kind.inputs.sets != suite::SetUse::none ? "required for drawn curves" : "required";
  const auto value = suite::to_text(field, default_study(kind));
  return "default " + (value.empty() ? std::string(field.left_out) : value);
}

std::string key_text(const Kind& kind, const Field& field) {
  const auto type = std::visit(TypeText(), field.value(default_study(kind)));
  const auto example = fmt::format("{} = {}", field.key, example_of(kind, field));
  return wrapped(fmt::format("  {}: ", field.key),
                 fmt::format("{}; {}; {}", field.meaning, type, default_of(kind, field)), 6, columns) +
         fmt::format("      {}\n", example);
}

/// The restrictions of a kind on the keys of every kind.
std::vector<std::string> restrictions_of(const Kind& kind) {
  std::vector<std::string> all;
  const auto& inputs = kind.inputs;
  if (inputs.forms.size() < suite::given_forms.size()) {
    std::vector<std::string_view> forms;
    for (const Form form : inputs.forms) forms.push_back(name(form));
    all.push_back(fmt::format("curve: {} only; {}", fmt::join(forms, " or "), inputs.forms_reason));
  }
  if (inputs.double_only) all.emplace_back("scalar: double only");
  if (inputs.degree == suite::DegreeUse::not_a_key) all.push_back(fmt::format("no key {}", inputs.degree_reason));
  if (!kind.without.empty())
    all.push_back(fmt::format("no keys {}: {}", fmt::join(kind.without, ", "), kind.without_reason));
  if (inputs.degree == suite::DegreeUse::optional) all.emplace_back("degree: may be left out where there are points");
  if (!inputs.least_degree_reason.empty()) all.push_back(fmt::format("degree: {}", inputs.least_degree_reason));
  if (inputs.parameters == suite::Parameters::from_0_to_1)
    all.push_back(fmt::format("t_interval: {}, within 0 and 1", inputs.parameters_reason));
  if (inputs.parameters == suite::Parameters::whole)
    all.push_back(fmt::format("t_interval: [0, 1] only; {}", inputs.parameters_reason));
  if (inputs.sets == suite::SetUse::none) all.push_back(fmt::format("no key curves: {}", inputs.sets_reason));
  if (inputs.independent_points) all.emplace_back("generator: none that draws a curve as a whole");
  if (!kind.has_baseline) all.emplace_back("baseline: exact only");
  return all;
}

/// The description of a kind: its own keys, then its restrictions on the others.
std::string own_text(const Kind& kind) {
  std::string text = wrapped(fmt::format("{}: ", kind.id), kind.about, 4, columns);
  for (const Field& field : kind.own) text += key_text(kind, field);
  for (const auto& line : restrictions_of(kind)) text += wrapped("  ", line, 6, columns);
  return text;
}

std::string shared_text(const Kind& kind) {
  std::string text;
  for (const Field* field : suite::fields_of(kind))
    if (suite::shared_fields().data() <= field && field < suite::shared_fields().data() + suite::shared_fields().size())
      text += key_text(kind, *field);
  return text;
}

Json text_schema() { return {{"type", "string"}}; }
/// Numbers may also be strings, in decimal or hexadecimal.
Json number_schema() { return {{"type", Json::array({"number", "string"})}}; }
Json whole_schema() { return {{"type", "integer"}}; }

template <class Enum>
Json word_schema() {
  return {{"enum", suite::all_words<Enum>()}};
}

Json list_schema(Json items) { return {{"type", "array"}, {"minItems", 1}, {"items", std::move(items)}}; }

struct TypeSchema {
  Json operator()(const suite::Kind* const* /*type*/) const { return text_schema(); }
  Json operator()(const std::string* /*type*/) const { return text_schema(); }
  template <suite::Worded Enum>
  Json operator()(const Enum* /*type*/) const {
    return word_schema<Enum>();
  }
  Json operator()(const std::int64_t* /*type*/) const { return whole_schema(); }
  Json operator()(const std::vector<int>* /*type*/) const { return list_schema(whole_schema()); }
  Json operator()(const std::vector<double>* /*type*/) const { return list_schema(number_schema()); }
  Json operator()(const std::vector<suite::Interval>* /*type*/) const {
    return list_schema({{"type", "array"}, {"minItems", 2}, {"maxItems", 2}, {"items", number_schema()}});
  }
  Json operator()(const std::vector<std::string>* /*type*/) const { return list_schema(text_schema()); }
  template <suite::Worded Enum>
  Json operator()(const std::vector<Enum>* /*type*/) const {
    return list_schema(word_schema<Enum>());
  }
};

Json key_schema(const Kind& kind, const Field& field) {
  Json schema = std::visit(TypeSchema(), field.value(default_study(kind)));
  if (field.key == "kind") schema = {{"const", kind.id}};
  if (field.bare_if_single) schema = {{"anyOf", Json::array({schema, text_schema()})}};
  if (field.key == "curve") {
    schema = {{"enum", Json::array()}};
    for (const Form form : kind.inputs.forms) {
      schema["enum"].push_back(name(form));
      for (const auto& earlier : suite::earlier_words<Form>)
        if (earlier.value == form) schema["enum"].push_back(earlier.word);
    }
  }
  schema["description"] =
      fmt::format("{}; {}; example: {}", field.meaning, default_of(kind, field), example_of(kind, field));
  return schema;
}

/// The schema of a kind. `definitions` has the schemas of keys, each as the first kind with the key has it; a kind with the
/// same one refers to it.
Json kind_schema(const Kind& kind, Json& definitions) {
  Json schema{{"type", "object"}, {"description", kind.about}, {"additionalProperties", false}};
  for (const Field* field : suite::fields_of(kind)) {
    const auto name = fmt::format("key_{}", field->key);
    Json key = key_schema(kind, *field);
    if (!definitions.contains(name)) definitions[name] = key;
    if (definitions[name] == key) key = {{"$ref", "#/definitions/" + name}};
    schema["properties"][std::string(field->key)] = std::move(key);
    if (!suite::is_required(kind, *field)) continue;
    if (field->key == "degree" && kind.inputs.sets != suite::SetUse::none)  // curve sets have degrees
      schema["anyOf"] = {{{"required", {"degree"}}}, {{"required", {"curves"}}}};
    else
      schema["required"].push_back(field->key);
  }
  return schema;
}

}  // namespace

std::string kinds_text() {
  std::string text = "Keys of every kind of study:\n" + shared_text(studies::accuracy_kind.asks) + "\n";
  for (const Kind* kind : studies::kinds()) text += own_text(*kind) + "\n";
  return text + "`list kinds KIND` shows all keys of one kind and an example.\n";
}

std::string kind_text(const std::string& id) {
  const auto found = std::ranges::find(studies::kinds(), id, &Kind::id);
  if (found == studies::kinds().end()) {
    std::vector<std::string> ids;
    for (const Kind* known : studies::kinds()) ids.emplace_back(known->id);
    throw Failure(Exit::usage, fmt::format("{}: unknown kind{}", echo(id), suite::suggestion(id, ids)));
  }
  const Kind* kind = *found;
  return own_text(*kind) + "\nKeys of every kind:\n" + shared_text(*kind) + "\nExample:\n" + example_study(*kind);
}

std::string example_study(const Kind& kind) {
  std::string text = "[[study]]\n";
  for (const Field* field : suite::fields_of(kind))
    if (suite::is_required(kind, *field) || field->key == "methods" || (field->key == "degree"))
      text += fmt::format("{} = {}\n", field->key, example_of(kind, *field));
  return text;
}

std::string suite_schema() {
  Json study{{"type", "object"}, {"required", {"id", "kind"}}, {"oneOf", Json::array()}};
  Json definitions;
  for (const Kind* kind : studies::kinds()) {
    definitions[std::string(kind->id)] = kind_schema(*kind, definitions);
    study["oneOf"].push_back({{"$ref", fmt::format("#/definitions/{}", kind->id)}});
  }
  const Json schema{
      {"$schema", "http://json-schema.org/draft-07/schema#"},
      {"title", "Suite of bezierbench"},
      {"type", "object"},
      {"required", {"schema_version", "suite", "study"}},
      {"additionalProperties", false},
      {"properties",
       {{"schema_version", {{"const", 1}}},
        {"suite",
         {{"type", "object"},
          {"required", {"id"}},
          {"additionalProperties", false},
          {"properties",
           {{"id", text_schema()}, {"title", text_schema()}, {"seed", whole_schema()}, {"seconds", whole_schema()}}}}},
        {"study", list_schema(std::move(study))}}},
      {"definitions", std::move(definitions)}};
  return schema.dump(2) + "\n";
}

}  // namespace bezierbench::cli
