// SPDX-License-Identifier: MIT
#include "experiments/tables/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/sample/curve_slice.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::tables {

namespace {

const bundle::DeclaredTable& declared(std::string_view file) {
  const auto* table = bundle::declared_table(file);
  if (table == nullptr) throw std::logic_error(fmt::format("{}: no table of tables.schema.json", file));
  return *table;
}

struct ToText {
  std::string operator()(std::monostate /*none*/) const { return ""; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(double number) const { return number::decimal(number); }
  std::string operator()(std::int64_t number) const { return std::to_string(number); }
  std::string operator()(const Hexadecimal& number) const { return number::hexadecimal(number.value); }
};

}  // namespace

std::string text(const Field& field) { return std::visit(ToText(), field); }

Row::Row(std::string_view file) : table_(&declared(file)), fields_(table_->columns.size()) {}

std::size_t Row::place(std::string_view column) const {
  const auto* found = table_->column(column);
  if (found == nullptr) throw std::logic_error(fmt::format("{}: no column {} in tables.schema.json", file(), column));
  return static_cast<std::size_t>(found - table_->columns.data());
}

Row& Row::put(std::string_view column, Field value) {
  Field& field = fields_[place(column)];
  if (field != Field()) throw std::logic_error(fmt::format("{}: column {} is set twice", file(), column));
  field = std::move(value);
  return *this;
}

std::vector<std::string> Row::texts() const {
  std::vector<std::string> texts;
  for (const auto& field : fields_) texts.push_back(text(field));
  return texts;
}

WrittenTable Table::written() const {
  const auto header = declared_.header();
  bundle::MethodDigester digester(declared_, declared_.digested(), [&](std::string_view column) {
    return static_cast<std::size_t>(std::ranges::find(header, column) - header.begin());
  });
  WrittenTable written{.text = bundle::csv_line(header), .digests = {}};
  for (const Row& row : rows_) {
    const auto texts = row.texts();
    written.text += bundle::csv_line(texts);
    if (declared_.is_deterministic) digester.add(texts);
  }
  written.digests = digester.digests();
  return written;
}

std::string Table::text() const {
  std::string text = bundle::csv_line(declared_.header());
  for (const Row& row : rows_) text += bundle::csv_line(row.texts());
  return text;
}

Table& Tables::table(std::string_view file) {
  const auto found = tables_.find(file);
  return found != tables_.end() ? found->second : tables_.try_emplace(std::string(file), declared(file)).first->second;
}

const Table* Tables::find(std::string_view file) const {
  const auto found = tables_.find(file);
  return found == tables_.end() ? nullptr : &found->second;
}

const std::vector<std::string>& cell_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> all{"study", "form", "method", "scalar", "dimension", "degree"};
    all.insert(all.end(), drawn_columns().begin(), drawn_columns().end());
    return all;
  }();
  return columns;
}

const std::vector<std::string>& drawn_columns() {
  static const std::vector<std::string> columns{"coordinate_range", "t_min", "t_max", "generator", "curves"};
  return columns;
}

std::vector<Field> drawn_fields(const sample::Cell& cell) {
  if (cell.slice) return {{}, {}, {}, field(suite::name(cell.slice->placement())), field(cell.slice->set().id)};
  return {cell.coordinate_range, cell.t_interval.min, cell.t_interval.max, cell.generator, {}};
}

std::vector<Field> cell_fields(const suite::Study& study, const sample::Cell& cell, std::string_view method,
                               suite::ScalarKind scalar) {
  std::vector<Field> fields{field(study.id),       field(name(study.form)), field(method), field(suite::name(scalar)),
                            field(cell.dimension), field(cell.degree)};
  for (auto& drawn : drawn_fields(cell)) fields.push_back(std::move(drawn));
  return fields;
}

std::string describe(const suite::Study& study, const sample::Cell& cell, suite::ScalarKind scalar) {
  if (cell.slice)
    return fmt::format("study {}, {} {} degree {}, curves {}, {}", study.id, name(study.form), suite::name(scalar),
                       cell.degree, cell.slice->set().id, suite::name(cell.slice->placement()));
  return fmt::format("study {}, {} {} degree {}, range {}, t in [{}, {}], generator {}", study.id, name(study.form),
                     suite::name(scalar), cell.degree, number::decimal(cell.coordinate_range),
                     number::decimal(cell.t_interval.min), number::decimal(cell.t_interval.max), cell.generator);
}

}  // namespace bezierbench::tables
