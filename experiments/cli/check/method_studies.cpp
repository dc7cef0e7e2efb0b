// SPDX-License-Identifier: MIT
#include "experiments/cli/check/method_studies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/echo.hpp"
#include "experiments/failure.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/nearest.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::cli {
namespace {

/// The problem that the methods of a study solve; empty for a study without methods.
std::optional<Problem> problem_of(const suite::Study& study) {
  const auto& kind = suite::kind_of(study);
  if (suite::find_field(kind, "methods") == nullptr) return std::nullopt;
  if (kind.chains) return Problem::conversion;
  if (kind.problem) return kind.problem;
  if (!kind.timed || study.methods.empty()) return Problem::evaluation;
  for (const auto* info : every_method())
    if (info->problem != Problem::conversion && suite::means(study.methods.front(), info->id)) return info->problem;
  return std::nullopt;
}

/// Whether the study names the method, or all that apply, which peers are not among.
bool names(const suite::Study& study, const std::string& id) {
  if (study.methods.empty()) return !suite::is_peer(id);
  return std::ranges::any_of(study.methods, [&](const auto& pattern) { return suite::means(pattern, id); });
}

/// Whether the method takes the curves of the study and solves its problem.
bool applies(const suite::Study& study, const std::string& id) {
  const auto problem = problem_of(study);
  return std::ranges::any_of(every_method(), [&](const MethodInfo* info) {
    return info->id == id && problem == info->problem && study.curve == info->form;
  });
}

/// The studies that `keep` keeps, with no other method.
template <class Keep>
std::vector<suite::Suite> only(std::vector<suite::Suite> suites, const std::string& id, const Keep& keep) {
  for (auto& one : suites) {
    std::erase_if(one.studies, [&](const suite::Study& study) { return !keep(study); });
    for (auto& study : one.studies) study.methods = {id};
  }
  std::erase_if(suites, [](const suite::Suite& one) { return one.studies.empty(); });
  return suites;
}

}  // namespace

void require_method(const std::string& id) {
  std::vector<std::string> known;
  for (const auto* info : every_method()) known.emplace_back(info->id);
  if (std::ranges::find(known, id) == known.end())
    throw Failure(Exit::usage,
                  fmt::format("{}: no such method{}; see `list methods`", echo(id), suite::suggestion(id, known)));
}

std::vector<suite::Suite> studies_that_judge(const std::vector<suite::Suite>& suites, const std::string& id) {
  return only(suites, id, [&](const suite::Study& study) {
    return !suite::kind_of(study).timed && names(study, id) && applies(study, id);
  });
}

std::vector<suite::Suite> studies_that_time(const std::vector<suite::Suite>& suites, const std::string& id) {
  const auto times = [&](const suite::Study& study) {
    return studies::is_kind(study, studies::timing_kind) && applies(study, id);
  };
  auto naming = only(suites, id, [&](const suite::Study& study) { return times(study) && names(study, id); });
  return naming.empty() ? only(suites, id, times) : naming;
}

}  // namespace bezierbench::cli
