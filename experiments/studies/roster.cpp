// SPDX-License-Identifier: MIT
#include "experiments/studies/roster.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "experiments/judge/methods.hpp"
#include "experiments/suite/ids.hpp"

namespace bezierbench::studies {

extern const StudyKind search_kind, conversion_kind, derivative_kind, arc_length_kind, inverse_arc_length_kind,
    projection_kind, interpolation_kind, fitting_kind, subdivision_kind, hard_cases_kind, guarantees_kind,
    exhaustive_kind, grid_kind, bspline_kind, flattening_kind, bounds_kind, easing_kind, easing_floats_kind, roots_kind;

namespace {

constexpr std::array roster{&accuracy_kind,
                            &search_kind,
                            &conversion_kind,
                            &timing_kind,
                            &derivative_kind,
                            &arc_length_kind,
                            &inverse_arc_length_kind,
                            &projection_kind,
                            &interpolation_kind,
                            &fitting_kind,
                            &subdivision_kind,
                            &hard_cases_kind,
                            &guarantees_kind,
                            &exhaustive_kind,
                            &grid_kind,
                            &bspline_kind,
                            &flattening_kind,
                            &bounds_kind,
                            &easing_kind,
                            &easing_floats_kind,
                            &roots_kind};

bool means_an_evaluator(const std::string& pattern) {
  constexpr int any_dimension = 2;
  return std::ranges::any_of(judge::methods<double>(any_dimension),
                             [&](const auto& kernel) { return suite::means(pattern, kernel.info->id); });
}

/// The kind that judges the first method that is not an evaluator.
const StudyKind& kind_named_by(const std::vector<std::string>& patterns) {
  for (const auto& pattern : patterns) {
    if (means_an_evaluator(pattern)) continue;
    const auto means = [&](const MethodInfo* info) { return suite::means(pattern, info->id); };
    for (const auto* one : roster)
      if (one->methods != nullptr && std::ranges::any_of(one->methods(), means)) return *one;
  }
  return accuracy_kind;
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

const StudyKind& study_kind(const suite::Study& study) {
  return **std::ranges::find_if(roster, [&](const StudyKind* one) { return is_kind(study, *one); });
}

bool is_kind(const suite::Study& study, const StudyKind& kind) { return &suite::kind_of(study) == &kind.asks; }

std::unique_ptr<run::Job> make_job(const suite::Study& study, const run::JobContext& context) {
  return study_kind(study).make(study, context);
}

std::vector<const MethodInfo*> companion_infos() {
  std::vector<const MethodInfo*> all;
  for (const auto* one : roster)
    if (one->methods != nullptr) std::ranges::copy(one->methods(), std::back_inserter(all));
  std::stable_partition(all.begin(), all.end(), [](const MethodInfo* info) { return !suite::is_peer(info->id); });
  return all;
}

const suite::Kind& kind_of_inputs(const suite::Study& study) {
  return is_kind(study, timing_kind) ? kind_named_by(study.methods).asks : suite::kind_of(study);
}

const StudyKind& timed_kind(const suite::Study& study) {
  const auto& named = kind_named_by(study.methods);
  judge::check_timed(study, named.asks);
  return named;
}

}  // namespace bezierbench::studies
