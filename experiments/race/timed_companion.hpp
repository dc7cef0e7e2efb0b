// SPDX-License-Identifier: MIT
// The timing of all companion problems: a race for each cell and case, whose trials are drawn once for all repetitions.
// Methods solve them one after the other, from the control points on, preparation included (mode one_shot). Their
// answers are first judged against the truth and later compared with the judged bits. Times are per answer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "experiments/judge/trial_problem.hpp"
#include "experiments/race/race.hpp"

namespace bezierbench::race {

/// The races of a study of a companion problem, still without methods.
inline std::vector<Race> companion_races(const suite::Study& study, judge::CaseAxes axes) {
  axes.placement = false;  // only the first placement is timed
  axes.knots = false;      // and the first kind of knots
  const auto all_cases = judge::cases_of(study, axes);
  auto with_degree = study;
  if (!axes.degree) with_degree.degree = {judge::segment_degree};
  std::vector<Race> races;
  for (const auto& cell : sample::cells(with_degree))
    for (const auto& case_values : all_cases)
      races.push_back({cell, suite::ScalarKind::float64, suite::Mode::one_shot, {}, case_values});
  return races;
}

/// The trials of one race.
template <judge::TrialProblem P>
class CompanionTrials {
 public:
  CompanionTrials(const Race& race, const suite::Study& study, std::uint64_t seed)
      : CompanionTrials(judge::TrialPart{race.cell, race.case_values}, study, seed) {}

  [[nodiscard]] std::size_t count() const { return drawn_.size(); }
  void ask(const typename P::Kernel& method, std::size_t k, typename P::Answer& answer) const {
    problem_.ask(method, drawn_[k], tolerance_, answer);
  }
  [[nodiscard]] bool is_right(const typename P::Kernel& method, std::size_t k, const typename P::Answer& answer) const {
    return problem_.is_right(method, drawn_[k], tolerance_, answer);
  }

 private:
  CompanionTrials(const judge::TrialPart& part, const suite::Study& study, std::uint64_t seed)
      : problem_(study, seed, part), tolerance_(part.values.tolerance.value_or(0)), drawn_(P::timed_trials(part)) {
    for (std::size_t k = 0; k < drawn_.size(); ++k) problem_.draw(k, drawn_[k]);
  }

  P problem_;
  double tolerance_;
  std::vector<typename P::Drawn> drawn_;
};

/// How many answers a call of `ask` gives: 1, unless the problem has a number.
template <judge::TrialProblem P>
consteval std::size_t answers_per_call() {
  if constexpr (requires { P::answers_per_call; })
    return P::answers_per_call;
  else
    return 1;
}

/// One method on the trials of a race, and the answers that it must reproduce bit for bit.
template <judge::TrialProblem P>
class CompanionRival {
 public:
  CompanionRival(const CompanionTrials<P>& trials, const typename P::Kernel& kernel)
      : trials_(trials), kernel_(kernel), answers_(trials.count()) {
    overwrite();
    run();
    judged_ = answers_;
    overwrite();
  }
  void run() {
    for (std::size_t k = 0; k < answers_.size(); ++k) trials_.ask(kernel_, k, answers_[k]);
  }
  bool check() {
    bool same = true;
    for (std::size_t k = 0; k < answers_.size(); ++k)
      same = std::ranges::equal(P::numbers(answers_[k]), P::numbers(judged_[k]), same_bits) && same;
    overwrite();
    return same;
  }
  [[nodiscard]] bool is_right() const {
    bool right = true;
    for (std::size_t k = 0; k < judged_.size(); ++k) right = right && trials_.is_right(kernel_, k, judged_[k]);
    return right;
  }

 private:
  static bool same_bits(std::span<const double> a, std::span<const double> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
  }
  /// Overwrites the results, so that a run that does nothing fails the next check.
  void overwrite() {
    for (auto& answer : answers_)
      for (const std::span<double> numbers : P::numbers(answer))
        std::ranges::fill(numbers, std::numeric_limits<double>::quiet_NaN());
  }

  const CompanionTrials<P>& trials_;
  const typename P::Kernel& kernel_;
  std::vector<typename P::Answer> answers_;
  std::vector<typename P::Answer> judged_;
};

template <judge::TrialProblem P>
std::vector<Race> races_of_companion(const suite::Study& study) {
  auto races = companion_races(study, P::axes);
  bool any_of_form = races.empty();
  for (auto& race : races)
    for (const auto* kernel : judge::chosen_trial_kernels<P>(study, race.cell.dimension)) {
      any_of_form = true;
      if (judge::takes<P>(*kernel->info, race.cell)) race.methods.push_back(kernel->info);
    }
  judge::require_form(study, any_of_form);
  return races;
}

template <judge::TrialProblem P>
JudgedRivals rivals_of_companion(const Race& race, const suite::Study& study, std::uint64_t seed,
                                 std::shared_ptr<const void>& kept) {
  if (kept == nullptr) kept = std::make_shared<const CompanionTrials<P>>(race, study, seed);
  const auto trials = std::static_pointer_cast<const CompanionTrials<P>>(kept);
  JudgedRivals all{{}, {}, trials};
  for (const auto* info : race.methods) {
    const auto& kernel = *std::ranges::find(P::kernels(race.cell.dimension), info, &P::Kernel::info);
    const auto rival = std::make_shared<CompanionRival<P>>(*trials, kernel);
    all.judged.push_back({rival->is_right()});
    all.rivals.push_back({std::string(info->id), trials->count() * answers_per_call<P>(), [rival] { rival->run(); },
                          [rival] { return rival->check(); }});
  }
  return all;
}

template <judge::TrialProblem P>
constexpr TimedProblem timed_companion(Size size = Size::unclaimed) {
  return {size, races_of_companion<P>, rivals_of_companion<P>};
}

}  // namespace bezierbench::race
