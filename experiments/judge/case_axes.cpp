// SPDX-License-Identifier: MIT
#include "experiments/judge/case_axes.hpp"

#include <fmt/format.h>

#include <array>
#include <span>

#include "experiments/sample/data_kind.hpp"
#include "experiments/sample/knot_kind.hpp"
#include "experiments/sample/placement.hpp"
#include "experiments/suite/kind.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::judge {
namespace {

/// Every case once for each value. An empty list of values leaves the cases unchanged.
template <class T, class Set>
void sweep(std::vector<CaseValues>& all, const std::vector<T>& values, Set set) {
  if (values.empty()) return;
  std::vector<CaseValues> swept;
  for (const auto& one : all)
    for (const auto& value : values) set(swept.emplace_back(one), value);
  all = std::move(swept);
}

template <class T>
std::vector<std::string_view> ids_of(std::span<const T> all) {
  std::vector<std::string_view> ids;
  for (const auto& one : all) ids.push_back(one.id);
  return ids;
}

constexpr std::array columns_of_times{case_column::order, case_column::tolerance, case_column::points,
                                      case_column::data};

}  // namespace

namespace case_column {

std::string order_field(const CaseValues& values) { return values.order ? std::to_string(*values.order) : ""; }
std::string tolerance_field(const CaseValues& values) {
  return values.tolerance ? number::decimal(*values.tolerance) : "";
}
std::string points_field(const CaseValues& values) { return values.points ? std::to_string(*values.points) : ""; }

}  // namespace case_column

const std::vector<std::string>& case_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> names;
    for (const auto& column : columns_of_times) names.emplace_back(column.name);
    return names;
  }();
  return columns;
}

std::vector<std::string> case_fields(const CaseValues& case_values) {
  std::vector<std::string> fields;
  for (const auto& column : columns_of_times) fields.push_back(column.field(case_values));
  return fields;
}

std::vector<CaseValues> cases_of(const suite::Study& study, const CaseAxes& axes) {
  std::vector<CaseValues> all(1);
  sweep(all, study.order, [](CaseValues& one, int order) { one.order = order; });
  if (axes.tolerance) sweep(all, study.tolerance, [](CaseValues& one, double tolerance) { one.tolerance = tolerance; });
  sweep(all, study.points, [](CaseValues& one, int points) { one.points = points; });
  if (axes.data) sweep(all, ids_of(sample::data_kinds()), [](CaseValues& one, auto id) { one.data = id; });
  if (axes.placement)
    sweep(all, sample::placement_ids(study.form), [](CaseValues& one, auto id) { one.placement = id; });
  if (axes.knots) sweep(all, ids_of(sample::knot_kinds()), [](CaseValues& one, auto id) { one.knots = id; });
  return all;
}

}  // namespace bezierbench::judge
