// SPDX-License-Identifier: MIT
#include "experiments/compare/changes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "experiments/number/number.hpp"

namespace bezierbench::compare {

ResultPair shown_change(const AccuracyRow& row) {
  if (row.largest && !same_value(row.largest->a, row.largest->b)) return *row.largest;
  return {row.column, row.a, row.b};
}

double growth(const AccuracyRow& row) {
  const auto change = shown_change(row);
  const auto a = number::parse_number(change.a);
  const auto b = number::parse_number(change.b);
  const double ratio = a && b ? std::abs(*b) / std::abs(*a) : std::numeric_limits<double>::quiet_NaN();
  return std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio;
}

std::vector<MethodChange> method_changes(const AccuracyComparison& accuracy) {
  std::map<std::string, MethodChange> methods;
  for (const auto& row : accuracy.rows) {
    auto& change = methods[row.inputs.field("method")];
    change.method = row.inputs.field("method");
    ++change.rows;
    if (!row.identical) change.differing.push_back(&row);
  }
  std::vector<MethodChange> changes;
  for (auto& [method, change] : methods) {
    if (change.differing.empty()) continue;
    std::ranges::stable_sort(change.differing, std::greater(), [](const auto* row) { return growth(*row); });
    changes.push_back(std::move(change));
  }
  std::ranges::stable_sort(changes, std::greater(),
                           [](const MethodChange& change) { return growth(*change.differing.front()); });
  return changes;
}

}  // namespace bezierbench::compare
