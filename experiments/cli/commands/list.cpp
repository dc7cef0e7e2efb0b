// SPDX-License-Identifier: MIT `list`: tables of what the program knows, and the keys of each kind of study as text, as
// an example and as a JSON Schema.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/external/method.hpp"
#include "experiments/failure.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/terminal.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/echo.hpp"
#include "reference/published/published.hpp"

namespace bezierbench::cli {
namespace {

/// A suite that comes with the program.
struct Shipped {
  std::string file_name;
  std::string text;
  suite::Suite suite;
};

std::vector<Shipped> all_shipped() {
  const auto known = vocabulary_of_all_builds();
  std::vector<Shipped> all;
  for (const auto& id : shipped_suites()) {
    const auto file = suite_file(id);
    auto text = bundle::read_file(file);
    auto one = suite::parse_suites(text, file.string(), known);
    all.push_back({file.filename().string(), std::move(text), std::move(one.front())});
  }
  return all;
}

std::string suites_csv() {
  bundle::CsvTable table({"id", "file", "seed", "studies", "seconds", "question", "title"});
  for (const auto& [file_name, text, one] : all_shipped()) {
    const auto [question, seconds] = suite::declared(text);
    table.add_row({one.id, file_name, std::to_string(one.seed), std::to_string(one.studies.size()),
                   seconds ? std::to_string(*seconds) : "", question, one.title});
  }
  return table.text();
}

std::string studies_csv() {
  bundle::CsvTable table({"id", "suite", "kind", "form", "title"});
  for (const auto& shipped : all_shipped())
    for (const auto& study : shipped.suite.studies)
      table.add_row({study.id, shipped.suite.id, std::string(suite::kind_of(study).id), std::string(name(study.form)),
                     study.title});
  return table.text();
}

/// A CSV text for people, in the width of the terminal and without the columns that only programs need.
std::string fitted_csv(const std::string& csv, const std::vector<std::string>& for_programs) {
  const auto document = bundle::parse_csv(csv, "table");
  std::vector<std::vector<std::string>> lines(document.row_count() + 1);
  for (const auto& column : document.header()) {
    if (std::ranges::find(for_programs, column) != for_programs.end()) continue;
    lines.front().push_back(column);
    for (std::size_t row = 0; row < document.row_count(); ++row) lines[row + 1].push_back(document.at(row, column));
  }
  return fitted(std::move(lines), terminal_width(STDOUT_FILENO));
}

void add_format(Command command, std::string& format) {
  command.option("--format", format, "text fits the terminal, csv is for programs").one_of({"text", "csv"});
}

void add_topic(Command list, const std::string& topic, const std::string& help, const std::function<std::string()>& csv,
               const std::shared_ptr<std::string>& format, const std::vector<std::string>& for_programs = {}) {
  auto command = list.command(topic, help);
  add_format(command, *format);
  command.action([csv, format, for_programs] {
    const auto text = csv();
    fmt::print("{}", *format == "csv" ? text : fitted_csv(text, for_programs));
  });
}

/// Which methods are listed; an empty text filters nothing.
struct MethodFilter {
  std::string glob;
  std::string problem;
  std::string form;
  std::string guarantee;
  std::string format = "text";

  [[nodiscard]] bool takes(const bundle::CsvDocument& methods, std::size_t row) const {
    const auto is = [&](const char* column, const std::string& word) {
      return word.empty() || methods.at(row, column) == word;
    };
    return (glob.empty() || suite::matches(glob, methods.at(row, "id"))) && is("problem", problem) &&
           is("form", form) && (guarantee.empty() || !kept(methods, row).empty());
  }

  /// The word of the guarantee in the row, such as `monotone:1`, which is kept up to degree 1; empty without one.
  [[nodiscard]] std::string kept(const bundle::CsvDocument& methods, std::size_t row) const {
    std::istringstream words(methods.at(row, "guarantees"));
    for (std::string word; words >> word;)
      if (word.substr(0, word.find(':')) == guarantee) return word;
    return "";
  }
};

/// A table for each problem, with few of the columns.
std::string methods_text(const bundle::CsvDocument& methods, const std::vector<std::size_t>& chosen,
                         const MethodFilter& filter) {
  std::map<std::string, std::vector<std::vector<std::string>>> tables;
  std::vector<std::string> problems;
  for (const auto row : chosen) {
    const auto problem = methods.at(row, "problem");
    auto& lines = tables[problem];
    if (lines.empty()) {
      problems.push_back(problem);
      lines.push_back({problem, "form", "bound", filter.guarantee.empty() ? "cost" : "keeps"});
    }
    lines.push_back({methods.at(row, "id"), methods.at(row, "form"), methods.at(row, "bound"),
                     filter.guarantee.empty() ? methods.at(row, "flops") : filter.kept(methods, row)});
  }
  std::string text;
  for (const auto& problem : problems)
    text += (text.empty() ? "" : "\n") + fitted(std::move(tables[problem]), terminal_width(STDOUT_FILENO));
  return text;
}

void print_methods(const std::string& csv, const MethodFilter& filter) {
  const auto methods = bundle::parse_csv(csv, "methods");
  bundle::CsvTable table(methods.header());
  std::vector<std::size_t> chosen;
  for (std::size_t row = 0; row < methods.row_count(); ++row) {
    if (!filter.takes(methods, row)) continue;
    chosen.push_back(row);
    table.add_row(methods.row(row));
  }
  if (chosen.empty() && !filter.glob.empty() && !suite::is_pattern(filter.glob)) {
    std::vector<std::string> known;
    for (std::size_t row = 0; row < methods.row_count(); ++row) known.push_back(methods.at(row, "id"));
    if (std::ranges::find(known, filter.glob) == known.end())
      throw Failure(Exit::usage, "{}: no such method{}", echo(filter.glob), suite::suggestion(filter.glob, known));
  }
  if (chosen.empty()) throw Failure(Exit::usage, "no method passes all of these filters; remove one of them");
  fmt::print("{}", filter.format == "csv" ? table.text() : methods_text(methods, chosen, filter));
}

std::vector<std::string> names_of_problems() {
  std::vector<std::string> names;
  for (int k = 0; !name(static_cast<Problem>(k)).empty(); ++k) names.emplace_back(name(static_cast<Problem>(k)));
  return names;
}

std::vector<std::string> names_of_properties() {
  std::vector<std::string> names;
  for (const auto property : properties) names.emplace_back(name(property));
  return names;
}

void add_methods(Command list, const std::function<std::string()>& csv) {
  auto filter = std::make_shared<MethodFilter>();
  auto command =
      list.command("methods", "methods by problem, with form, bound and cost, as csv with all that is known");
  command.option("GLOB", filter->glob, "list only methods whose id matches this pattern");
  command.option("--problem", filter->problem, "list only methods of this problem").one_of(names_of_problems());
  command.option("--form", filter->form, "list only methods that take this form").one_of(suite::all_words<Form>());
  command.option("--guarantee", filter->guarantee, "list only methods that are proved to keep this property")
      .one_of(names_of_properties());
  add_format(command, filter->format);
  command.action([csv, filter] { print_methods(csv(), *filter); });
}

using Json = nlohmann::ordered_json;
using suite::Field;
using suite::Kind;

template <class Enum>
std::string words_of() {
  return fmt::format("{}", fmt::join(suite::all_words<Enum>(), ", "));
}

Json text_schema() { return {{"type", "string"}}; }
/// Numbers may also be strings, in decimal or hexadecimal.
Json number_schema() { return {{"type", Json::array({"number", "string"})}}; }
Json whole_schema() { return {{"type", "integer"}}; }
Json list_schema(Json items) { return {{"type", "array"}, {"minItems", 1}, {"items", std::move(items)}}; }

/// The values that may be written: in words, and as a schema.
struct Values {
  std::string text;
  Json schema;
};

/// They follow from the type of the slot that a field points to.
struct ValuesOfType {
  Values operator()(const suite::Kind* const* /*type*/) const { return {"the id of a kind", text_schema()}; }
  Values operator()(const std::string* /*type*/) const { return {"a string", text_schema()}; }
  template <suite::Worded Enum>
  Values operator()(const Enum* /*type*/) const {
    return {"one of " + words_of<Enum>(), {{"enum", suite::all_words<Enum>()}}};
  }
  Values operator()(const std::int64_t* /*type*/) const { return {"a whole number", whole_schema()}; }
  Values operator()(const std::vector<int>* /*type*/) const { return {"whole numbers", list_schema(whole_schema())}; }
  Values operator()(const std::vector<double>* /*type*/) const { return {"numbers", list_schema(number_schema())}; }
  Values operator()(const std::vector<suite::Interval>* /*type*/) const {
    return {"pairs of numbers",
            list_schema({{"type", "array"}, {"minItems", 2}, {"maxItems", 2}, {"items", number_schema()}})};
  }
  Values operator()(const std::vector<std::string>* /*type*/) const { return {"strings", list_schema(text_schema())}; }
  template <suite::Worded Enum>
  Values operator()(const std::vector<Enum>* /*type*/) const {
    return {"some of " + words_of<Enum>(), list_schema({{"enum", suite::all_words<Enum>()}})};
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
  const auto type = std::visit(ValuesOfType(), field.value(default_study(kind))).text;
  const auto example = fmt::format("{} = {}", field.key, example_of(kind, field));
  return wrapped(fmt::format("  {}: ", field.key),
                 fmt::format("{}; {}; {}", field.meaning, type, default_of(kind, field)), 6, reading_width()) +
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
  std::string text = wrapped(fmt::format("{}: ", kind.id), kind.about, 4, reading_width());
  for (const Field& field : kind.own) text += key_text(kind, field);
  for (const auto& line : restrictions_of(kind)) text += wrapped("  ", line, 6, reading_width());
  return text;
}

std::string shared_text(const Kind& kind) {
  std::string text;
  for (const Field* field : suite::fields_of(kind))
    if (suite::shared_fields().data() <= field && field < suite::shared_fields().data() + suite::shared_fields().size())
      text += key_text(kind, *field);
  return text;
}

Json key_schema(const Kind& kind, const Field& field) {
  Json schema = std::visit(ValuesOfType(), field.value(default_study(kind))).schema;
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

/// The schema of a kind. `definitions` has the schemas of keys, each as the first kind with the key has it; a kind with
/// the same one refers to it.
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

/// A [[study]] with the keys that the kind needs, as TOML.
std::string example_study(const Kind& kind) {
  std::string text = "[[study]]\n";
  for (const Field* field : suite::fields_of(kind))
    if (suite::is_required(kind, *field) || field->key == "methods" || (field->key == "degree"))
      text += fmt::format("{} = {}\n", field->key, example_of(kind, *field));
  return text;
}

std::vector<std::string> ids_of_kinds() {
  std::vector<std::string> ids;
  for (const auto* kind : studies::kinds()) ids.emplace_back(kind->id);
  return ids;
}

/// All keys of one kind, with an example. Throws Failure(Exit::usage) for an id of no kind.
std::string kind_text(const std::string& id) {
  const auto found = std::ranges::find(studies::kinds(), id, &Kind::id);
  if (found == studies::kinds().end())
    throw Failure(Exit::usage, "{}: unknown kind{}", echo(id), suite::suggestion(id, ids_of_kinds()));
  const Kind* kind = *found;
  return own_text(*kind) + "\nKeys of every kind:\n" + shared_text(*kind) + "\nExample:\n" + example_study(*kind);
}

/// A JSON Schema of suite files, draft 7, the one that editors support.
std::string suite_schema() {
  Json study{{"type", "object"}, {"required", {"id", "kind"}}, {"oneOf", Json::array()}};
  Json definitions;
  for (const Kind* kind : studies::kinds()) {
    definitions[std::string(kind->id)] = kind_schema(*kind, definitions);
    study["oneOf"].push_back({{"$ref", fmt::format("#/definitions/{}", kind->id)}});
  }
  const Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
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
                         {{"id", text_schema()},
                          {"title", text_schema()},
                          {"question", text_schema()},
                          {"seed", whole_schema()},
                          {"seconds", whole_schema()}}}}},
                      {"study", list_schema(std::move(study))}}},
                    {"definitions", std::move(definitions)}};
  return schema.dump(2) + "\n";
}

/// A topic with its own layout, since its texts are too long for a table.
void add_kinds(Command list) {
  struct Options {
    std::optional<std::string> kind;
    bool schema = false;
  };
  auto options = std::make_shared<Options>();
  auto command = list.command("kinds", "the kinds of studies, with their keys in a suite");
  command.option("KIND", options->kind, "print this kind only, with an example").takes("KIND", ids_of_kinds);
  command.flag("--json-schema", options->schema, "print a JSON Schema of suite files instead, for editors");
  command.action([options] {
    fmt::print("{}", options->schema ? suite_schema() : options->kind ? kind_text(*options->kind) : kinds_text());
  });
}

constexpr std::string_view worked_file = "worked_conversions.csv";

std::vector<double> numbers(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> values;
  for (double value = 0; stream >> value;) values.push_back(value);
  return values;
}

CurveView<double> view(Form form, const std::vector<double>& coefficients) {
  return {form, 1, static_cast<int>(coefficients.size()) - 1, coefficients};
}

/// Whether both are the same polynomial, exactly.
bool same(const std::vector<double>& control_points, const std::vector<double>& coefficients) {
  const auto exact = reference::converted(view(Form::bernstein, control_points));
  return std::ranges::equal(exact, coefficients, [](const reference::ExactPoint& point, double coefficient) {
    return (point.coordinate(0) - reference::exactly(coefficient)).numerator == 0;
  });
}

/// "6 of 7": how many conversions of this form give `to` from `from`, bit for bit.
std::string agreement(Form form, const std::vector<double>& from, const std::vector<double>& to) {
  int agree = 0;
  int all = 0;
  for (const auto& kernel : conversion_kernels<double>(1)) {
    if (kernel.info->form != form) continue;
    std::vector<double> converted(to.size());
    kernel.convert(view(form, from), converted.data());
    ++all;
    agree += converted == to ? 1 : 0;
  }
  return fmt::format("{} of {}", agree, all);
}

/// The table of `list worked`, of the worked conversions that [Report 001] prints, section 2.2: for each example and
/// axis the printed control points and power coefficients, whether the report calls them correct, whether they are, and
/// how many conversions give the printed side from the other one.
std::string worked_csv() {
  const auto tables = reference::published_tables();
  const auto table = std::ranges::find(tables, worked_file, &reference::PublishedTable::file_name);
  const auto printed = bundle::parse_csv(table->text, table->file_name);
  bundle::CsvTable judged({"example", "degree", "axis", "control_points", "coefficients", "printed_correct", "correct",
                           "to_power", "to_bernstein"});
  for (std::size_t row = 0; row < printed.row_count(); ++row) {
    const auto points = numbers(printed.at(row, "control_points"));
    const auto coefficients = numbers(printed.at(row, "coefficients"));
    judged.add_row({printed.at(row, "example"), printed.at(row, "degree"), printed.at(row, "axis"),
                    printed.at(row, "control_points"), printed.at(row, "coefficients"), printed.at(row, "correct"),
                    same(points, coefficients) ? "yes" : "no", agreement(Form::bernstein, points, coefficients),
                    agreement(Form::power, coefficients, points)});
  }
  return judged.text();
}

}  // namespace

void add_list(Command program, Exit& /*exit*/, std::span<const external::OwnMethod> own) {
  auto format = std::make_shared<std::string>("text");
  auto list =
      program.command("list", "list methods, suites, studies, kinds of studies, generators, worked conversions");
  list.needs_command();
  const auto methods = [own] {
    std::vector<suite::ExternalMethod> records;
    for (const auto& method : own) records.push_back(external::own(method, {}, nullptr)->record());
    return methods_csv(records);
  };
  add_methods(list, methods);
  add_topic(list, "suites", "the shipped suites, with the question that each answers and its processor seconds",
            suites_csv, format, {"file", "seed", "studies", "title"});
  add_topic(list, "studies", "the studies of the shipped suites", studies_csv, format);
  add_kinds(list);
  add_topic(list, "generators", "how random inputs are drawn", generators_csv, format);
  add_topic(list, "worked", "the worked conversions of the source report, judged", worked_csv, format);
}

std::string kinds_text() {
  std::string text = "Keys of every kind of study:\n" + shared_text(studies::accuracy_kind.asks) + "\n";
  for (const Kind* kind : studies::kinds()) text += own_text(*kind) + "\n";
  return text + "`list kinds KIND` shows all keys of one kind and an example.\n";
}

}  // namespace bezierbench::cli
