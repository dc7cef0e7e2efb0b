// SPDX-License-Identifier: MIT
#include "experiments/tables/tables.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace bezierbench::tables {
namespace {

const bundle::DeclaredTable& declared(std::string_view file) {
  const auto* table = bundle::declared_table(file);
  if (table == nullptr) throw std::logic_error(fmt::format("{}: no table of tables.schema.json", file));
  return *table;
}

}  // namespace

Row::Row(std::string_view file) : table_(declared(file)) {}

Row& Row::set(std::string_view column, std::string_view text) {
  const auto* found = table_.column(column);
  if (found == nullptr || found->is_deprecated)
    throw std::logic_error(fmt::format("{}: no column {} in tables.schema.json", file(), column));
  if (!fields_.try_emplace(std::string(column), text).second)
    throw std::logic_error(fmt::format("{}: column {} is set twice", file(), column));
  return *this;
}

Row& Row::set_each(const std::vector<std::string>& columns, const std::vector<std::string>& fields) {
  for (std::size_t k = 0; k < columns.size(); ++k) set(columns[k], fields.at(k));
  return *this;
}

std::vector<std::string> Row::fields() const {
  std::vector<std::string> all;
  for (const auto& name : table_.header()) {
    const auto found = fields_.find(name);
    all.push_back(found == fields_.end() ? "" : found->second);
  }
  return all;
}

bundle::CsvTable& Tables::table(const std::string& file) {
  const auto found = tables_.find(file);
  return found != tables_.end() ? found->second : tables_.try_emplace(file, declared(file).header()).first->second;
}

}  // namespace bezierbench::tables
