// SPDX-License-Identifier: MIT
#include "experiments/studies/asked.hpp"

#include <fmt/format.h>

#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"
#include "experiments/sample/data_kind.hpp"

namespace bezierbench::studies {
namespace {

void check_key(const suite::Study& study, std::string_view problem, std::string_view key, bool there, bool asked) {
  if (there == asked) return;
  throw Failure(Exit::usage, fmt::format("study \"{}\": the problem {} {} the key {}; {} it", study.id, problem,
                                         asked ? "needs" : "does not have", key, asked ? "add" : "remove"));
}

/// Every case once for each value; as they are where there is none.
template <class T, class Set>
void sweep(std::vector<Asked>& all, const std::vector<T>& values, Set set) {
  if (values.empty()) return;
  std::vector<Asked> swept;
  for (const auto& one : all)
    for (const auto& value : values) set(swept.emplace_back(one), value);
  all = std::move(swept);
}

}  // namespace

const std::vector<std::string>& asked_columns() {
  static const std::vector<std::string> columns{"order", "tolerance", "points", "data"};
  return columns;
}

std::vector<std::string> asked_fields(const Asked& asked) {
  return {asked.order ? std::to_string(*asked.order) : "", asked.tolerance ? number::decimal(*asked.tolerance) : "",
          asked.points ? std::to_string(*asked.points) : "", std::string(asked.data)};
}

std::vector<Asked> asked_of(const suite::Study& study, const Asks& asks, std::string_view problem) {
  check_key(study, problem, "degree", !study.degree.empty(), asks.degree);
  check_key(study, problem, "order", !study.order.empty(), asks.order);
  check_key(study, problem, "tolerance", !study.tolerance.empty(), asks.tolerance);
  check_key(study, problem, "points", !study.points.empty(), asks.points);
  std::vector<Asked> all(1);
  sweep(all, study.order, [](Asked& one, int order) { one.order = order; });
  sweep(all, study.tolerance, [](Asked& one, double tolerance) { one.tolerance = tolerance; });
  sweep(all, study.points, [](Asked& one, int points) { one.points = points; });
  if (!asks.data) return all;
  std::vector<std::string_view> kinds;
  for (const auto& kind : sample::data_kinds()) kinds.push_back(kind.id);
  sweep(all, kinds, [](Asked& one, std::string_view data) { one.data = data; });
  return all;
}

}  // namespace bezierbench::studies
