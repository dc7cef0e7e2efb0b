// SPDX-License-Identifier: MIT
#include "experiments/judge/case_axes.hpp"

#include <fmt/format.h>

#include "experiments/number/number.hpp"
#include "experiments/sample/data_kind.hpp"

namespace bezierbench::judge {
namespace {

/// Every case once for each value; as they are where there is none.
template <class T, class Set>
void sweep(std::vector<CaseValues>& all, const std::vector<T>& values, Set set) {
  if (values.empty()) return;
  std::vector<CaseValues> swept;
  for (const auto& one : all)
    for (const auto& value : values) set(swept.emplace_back(one), value);
  all = std::move(swept);
}

}  // namespace

const std::vector<std::string>& case_columns() {
  static const std::vector<std::string> columns{"order", "tolerance", "points", "data"};
  return columns;
}

std::vector<std::string> case_fields(const CaseValues& case_values) {
  return {case_values.order ? std::to_string(*case_values.order) : "",
          case_values.tolerance ? number::decimal(*case_values.tolerance) : "",
          case_values.points ? std::to_string(*case_values.points) : "", std::string(case_values.data)};
}

std::vector<CaseValues> cases_of(const suite::Study& study, bool each_data) {
  const auto& keys = suite::keys_of<suite::TimingKeys>(study);
  std::vector<CaseValues> all(1);
  sweep(all, keys.order, [](CaseValues& one, int order) { one.order = order; });
  sweep(all, keys.tolerance, [](CaseValues& one, double tolerance) { one.tolerance = tolerance; });
  sweep(all, keys.points, [](CaseValues& one, int points) { one.points = points; });
  if (!each_data) return all;
  std::vector<std::string_view> kinds;
  for (const auto& kind : sample::data_kinds()) kinds.push_back(kind.id);
  sweep(all, kinds, [](CaseValues& one, std::string_view data) { one.data = data; });
  return all;
}

}  // namespace bezierbench::judge
