// SPDX-License-Identifier: MIT
#include "experiments/bundle/schema/columns.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tables_schema.hpp"

namespace bezierbench::bundle {
namespace {

using Json = nlohmann::ordered_json;

const Json& tables_schema() {
  static const Json schema = Json::parse(tables_schema_text);
  return schema;
}

/// The part of the schema that the `$ref` of `part` names. It may have a `$ref` itself.
const Json& referred(const Json& part) {
  return tables_schema().at(Json::json_pointer(part.at("$ref").get_ref<const std::string&>().substr(1)));
}

/// A schema together with the schemas that it refers to.
class Declaration {
 public:
  explicit Declaration(const Json& part) : part_(part) {}

  /// The value of the keyword, or null. A keyword beside a `$ref` takes precedence over the one in the schema referred
  /// to.
  [[nodiscard]] const Json* find(const char* keyword) const {
    for (const Json* part = &part_;; part = &referred(*part)) {
      if (const auto found = part->find(keyword); found != part->end()) return &*found;
      if (!part->contains("$ref")) return nullptr;
    }
  }
  template <class T>
  [[nodiscard]] T value(const char* keyword, T otherwise) const {
    const Json* found = find(keyword);
    return found == nullptr ? otherwise : found->get<T>();
  }

 private:
  const Json& part_;
};

bool is_number_type(const Json& type) {
  if (type.is_array())
    return std::ranges::all_of(type, [](const Json& one) { return one == "null" || is_number_type(one); });
  return type == "number" || type == "integer";
}

/// Whether the word stands for a number that is not finite.
bool is_number_word(const Json& word) { return word == "inf" || word == "-inf" || word == "nan"; }

bool holds_numbers(const Json& part) {
  const Declaration declared(part);
  if (const Json* several = declared.find("anyOf")) {
    const auto is_null = [](const Json& one) { return one.contains("type") && one.at("type") == "null"; };
    return std::ranges::all_of(*several, [&](const Json& one) { return is_null(one) || holds_numbers(one); });
  }
  if (const Json* words = declared.find("enum")) return std::ranges::all_of(*words, is_number_word);
  if (const Json* word = declared.find("const")) return is_number_word(*word);
  const Json* type = declared.find("type");
  return type != nullptr && is_number_type(*type);
}

Column column_of(const std::string& name, const Json& part, bool of_deterministic) {
  const Declaration declared(part);
  Column column{.name = name,
                .is_key = declared.value("key", false),
                .is_number = holds_numbers(part),
                .is_digested = false,
                .accuses = declared.value("accuses", std::string()),
                .is_of_promise = declared.value("of_promise", false),
                .is_of_external = declared.value("of_external", false)};
  column.is_digested = of_deterministic && declared.value("digested", true);
  return column;
}

DeclaredTable table_of(const std::string& file, const Json& part) {
  const Declaration declared(part);
  DeclaredTable table{.file = file,
                      .is_deterministic = declared.value("deterministic", false),
                      .study = declared.value("study", std::string("study")),
                      .method = declared.value("method", std::string()),
                      .columns = {}};
  for (const auto& [name, column] : declared.find("items")->at("properties").items())
    table.columns.push_back(column_of(name, column, table.is_deterministic));
  if (const Json* timed = declared.find("timed")) {
    table.faults = timed->value("faults", table.faults);
    table.within_tolerance = timed->value("within_tolerance", std::string());
  }
  if (const Json* measures = declared.find("measures"); measures != nullptr && !measures->empty()) {
    table.measure = measures->begin().key();
    table.measure_words = measures->begin().value();
  }
  return table;
}

/// The names of the columns for which `is_meant` holds.
template <class Predicate>
std::vector<std::string> names(const std::vector<Column>& columns, Predicate is_meant) {
  std::vector<std::string> all;
  for (const auto& column : columns)
    if (is_meant(column)) all.push_back(column.name);
  return all;
}

}  // namespace

const Column* DeclaredTable::column(std::string_view name) const {
  const auto found = std::ranges::find(columns, name, &Column::name);
  return found == columns.end() ? nullptr : &*found;
}

std::vector<std::string> DeclaredTable::header() const {
  std::vector<std::string> all;
  for (const auto& one : columns) all.push_back(one.name);
  return all;
}

std::vector<std::string> DeclaredTable::digested() const {
  return names(columns, [](const Column& column) { return column.is_digested; });
}

const std::vector<DeclaredTable>& declared_tables() {
  static const std::vector<DeclaredTable> tables = [] {
    std::vector<DeclaredTable> all;
    for (const auto& [file, part] : tables_schema().at("properties").items()) all.push_back(table_of(file, part));
    return all;
  }();
  return tables;
}

const DeclaredTable* declared_table(std::string_view file) {
  const auto found = std::ranges::find(declared_tables(), file, &DeclaredTable::file);
  return found == declared_tables().end() ? nullptr : &*found;
}

int written_version() { return tables_schema().at("version").get<int>(); }

std::string last_reader_of_earlier() { return tables_schema().at("last_reader_of_earlier").get<std::string>(); }

}  // namespace bezierbench::bundle
