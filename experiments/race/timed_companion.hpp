// SPDX-License-Identifier: MIT
// What the timing of all companion problems shares: a race cell for each cell and case, whose trials are drawn once for
// all repetitions. Methods solve them one after the other, from the control points on, preparation included (mode
// one_shot). Their answers are first judged against the truth and later compared with the judged bits.
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
#include "experiments/race/timed_problem.hpp"

namespace bezierbench::race {

/// The race cells of a study of a companion problem, still without methods.
std::vector<RaceCell> companion_race_cells(const suite::Study& study, judge::CaseAxes axes);

/// The trials of one race cell.
template <judge::TrialProblem P>
class CompanionTrials {
 public:
  CompanionTrials(const RaceCell& race_cell, const suite::Study& study, std::uint64_t seed)
      : CompanionTrials(judge::TrialPart{race_cell.cell, race_cell.case_values}, study, seed) {}

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

/// One method on the trials of a race cell, and the answers that it must reproduce bit for bit.
template <judge::TrialProblem P>
class CompanionRival {
 public:
  CompanionRival(const CompanionTrials<P>& trials, const typename P::Kernel& kernel)
      : trials_(trials), kernel_(kernel), answers_(trials.count()) {
    spoil();
    run();
    judged_ = answers_;
    spoil();
  }
  void run() {
    for (std::size_t k = 0; k < answers_.size(); ++k) trials_.ask(kernel_, k, answers_[k]);
  }
  bool check() {
    bool same = true;
    for (std::size_t k = 0; k < answers_.size(); ++k)
      same = std::ranges::equal(P::numbers(answers_[k]), P::numbers(judged_[k]), same_bits) && same;
    spoil();
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
  void spoil() {
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
std::vector<RaceCell> race_cells_of_companion(const suite::Study& study) {
  auto race_cells = companion_race_cells(study, P::axes);
  for (auto& race_cell : race_cells)
    for (const auto* kernel : judge::chosen_trial_kernels<P>(study, race_cell.cell.dimension))
      if (judge::takes<P>(*kernel->info, race_cell.cell)) race_cell.methods.push_back(kernel->info);
  return race_cells;
}

template <judge::TrialProblem P>
JudgedRivals rivals_of_companion(const RaceCell& race_cell, const suite::Study& study, std::uint64_t seed,
                                 std::shared_ptr<const void>& kept) {
  if (kept == nullptr) kept = std::make_shared<const CompanionTrials<P>>(race_cell, study, seed);
  const auto trials = std::static_pointer_cast<const CompanionTrials<P>>(kept);
  JudgedRivals all{{}, {}, trials};
  for (const auto* info : race_cell.methods) {
    const auto& kernel = *std::ranges::find(P::kernels(race_cell.cell.dimension), info, &P::Kernel::info);
    const auto rival = std::make_shared<CompanionRival<P>>(*trials, kernel);
    all.judged.push_back({rival->is_right()});
    all.rivals.push_back(
        {std::string(info->id), trials->count(), [rival] { rival->run(); }, [rival] { return rival->check(); }});
  }
  return all;
}

template <judge::TrialProblem P>
constexpr TimedProblem timed_companion(Size size = Size::unclaimed) {
  return {size, race_cells_of_companion<P>, rivals_of_companion<P>};
}

}  // namespace bezierbench::race
