// SPDX-License-Identifier: MIT
#include "experiments/tables/cell_fields.hpp"

#include <fmt/format.h>

#include "experiments/sample/curve_slice.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::tables {

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
