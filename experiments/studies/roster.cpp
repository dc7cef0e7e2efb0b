// SPDX-License-Identifier: MIT
#include "experiments/studies/roster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/judge/methods.hpp"
#include "experiments/judge/study_inputs.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::studies {

extern const StudyKind search_kind, conversion_kind, roofline_kind, derivative_kind, arc_length_kind,
    inverse_arc_length_kind, projection_kind, interpolation_kind, fitting_kind, subdivision_kind, hard_cases_kind,
    guarantees_kind, exhaustive_kind, grid_kind, bspline_kind;

namespace {

constexpr std::array roster{&accuracy_kind,   &search_kind,        &conversion_kind, &timing_kind,
                            &roofline_kind,   &derivative_kind,    &arc_length_kind, &inverse_arc_length_kind,
                            &projection_kind, &interpolation_kind, &fitting_kind,    &subdivision_kind,
                            &hard_cases_kind, &guarantees_kind,    &exhaustive_kind, &grid_kind,
                            &bspline_kind};

const StudyKind& find(const suite::Study& study) {
  return **std::ranges::find_if(roster, [&](const StudyKind* one) { return is_kind(study, *one); });
}

bool means_an_evaluator(const std::string& pattern) {
  constexpr int any_dimension = 2;
  return std::ranges::any_of(judge::methods<double>(any_dimension),
                             [&](const auto& kernel) { return suite::means(pattern, kernel.info->id); });
}

Problem named_problem(const suite::Study& study) {
  for (const auto& pattern : study.methods) {
    if (means_an_evaluator(pattern)) continue;
    for (const auto* info : judge::companion_infos())
      if (suite::means(pattern, info->id)) return info->problem;
  }
  return Problem::evaluation;
}

}  // namespace

std::span<const suite::Kind* const> kinds() {
  static const auto all = [] {
    std::array<const suite::Kind*, roster.size()> each{};
    std::ranges::transform(roster, each.begin(), [](const StudyKind* one) { return &one->asks; });
    return each;
  }();
  return all;
}

const suite::Kind& kind(std::string_view id) {
  const auto found = std::ranges::find(kinds(), id, &suite::Kind::id);
  if (found == kinds().end()) throw std::out_of_range(std::string(id) + ": no kind of study");
  return **found;
}

bool is_kind(const suite::Study& study, const StudyKind& kind) { return &suite::kind_of(study) == &kind.asks; }

std::unique_ptr<run::Job> make_job(const suite::Study& study, const run::JobContext& context) {
  return find(study).make(study, context);
}

std::vector<std::vector<std::string>> tables_of(const suite::Study& study) {
  std::vector<std::vector<std::string>> all;
  for (std::string_view rest : find(study).tables) {
    if (rest.empty()) continue;
    auto& one_of = all.emplace_back();
    for (std::size_t bar = 0; bar != std::string_view::npos; rest.remove_prefix(std::min(bar, rest.size() - 1) + 1)) {
      bar = rest.find('|');
      one_of.push_back(fmt::format("{}.csv", rest.substr(0, bar)));
    }
  }
  return all;
}

const race::TimedProblem& timed_problem(const suite::Study& study) {
  const Problem problem = named_problem(study);
  const auto judging = std::ranges::find_if(
      roster, [&](const StudyKind* one) { return one->timed && one->asks.problem == std::optional(problem); });
  if (judging == roster.end())
    suite::refuse(
        study, {"methods", 0, {}, fmt::format("methods for the problem {} are not timed; name others", name(problem))});
  judge::check_timed(study, (*judging)->asks);
  return *(*judging)->timed;
}

}  // namespace bezierbench::studies
