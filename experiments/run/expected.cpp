// SPDX-License-Identifier: MIT
#include "experiments/run/expected.hpp"

#include <algorithm>
#include <optional>

#include "experiments/bundle/csv.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/plan.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::run {
namespace {

/// Whether the entry of `methods` is about other libraries, none of whose methods are in the list.
bool is_of_absent_peers(const std::string& entry, const bundle::CsvDocument& methods) {
  if (!suite::is_peer(entry)) return false;
  for (std::size_t row = 0; row < methods.row_count(); ++row)
    if (suite::means(entry, methods.at(row, "id"))) return false;
  return true;
}

/// The plan of one study. Empty where this build lacks the methods.
std::optional<Plan> plan_of(const RunRequest& request, const suite::Suite& suite, suite::Study study,
                            const bundle::CsvDocument& methods) {
  const bool names_some = !study.methods.empty();
  std::erase_if(study.methods, [&](const auto& entry) { return is_of_absent_peers(entry, methods); });
  if (names_some && study.methods.empty()) return std::nullopt;
  RunRequest one = request;
  one.suites = {suite};
  one.suites.front().studies = {std::move(study)};
  try {
    return Plan(one);
  } catch (const Failure&) {
    return std::nullopt;
  }
}

}  // namespace

bundle::Expected expected_of(const RunRequest& request) {
  bundle::Expected expected;
  expected.seed = request.suites.front().seed;
  const auto methods = bundle::parse_csv(request.methods_csv, "methods.csv");
  tables::Tables tables;
  for (const auto& suite : request.suites) {
    expected.suites.push_back(suite.id);
    for (const auto& study : suite.studies) {
      expected.studies.push_back(study.id);
      const auto plan = plan_of(request, suite, study, methods);
      if (!plan) continue;
      for (const auto& job : plan->jobs) job->list_rows(tables);
      if (!plan->studies.empty() && plan->jobs.front()->extent().rows > 0)
        for (auto& names : request.kinds.tables_of(study)) expected.tables.push_back({study.id, std::move(names)});
    }
  }
  for (const auto& [file, table] : tables.all())
    expected.plan.rows.emplace(file, bundle::parse_csv(table.text(), file));
  expected.plan.methods_csv = request.methods_csv;
  expected.plan.git_commit = request.git_commit;
  for (const auto& method : request.external) expected.plan.external.insert(method.id);
  return expected;
}

}  // namespace bezierbench::run
