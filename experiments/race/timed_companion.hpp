// SPDX-License-Identifier: MIT
// The part of timing a companion problem that is the same for each: a race cell for each cell and each thing that is
// asked, problems drawn once, methods that solve them in a row from the control points on, all that a method prepares
// included (mode one_shot), judged against the truth first and then held to the judged bits.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "experiments/judge/case_axes.hpp"
#include "experiments/judge/companions.hpp"
#include "experiments/judge/method_choice.hpp"
#include "experiments/race/timed_problem.hpp"

namespace bezierbench::race {

/// The problems of one race cell: `count()` of them, drawn by the constructor. `solve` is what is timed: it writes all
/// numbers of the answer to `result`, an array or vector of doubles. `each_data`: every kind of data is a case of its
/// own.
template <class P>
concept TimedCompanion = std::constructible_from<P, const RaceCell&, const suite::Study&, std::uint64_t> &&
    requires(const P& problems, const typename P::Kernel& kernel, std::size_t k, typename P::Result& result) {
  requires std::same_as<const Problem, decltype(P::problem)>;
  requires std::same_as<const bool, decltype(P::each_data)>;
  { P::kernels(int{}) } -> std::same_as<std::span<const typename P::Kernel>>;
  { problems.count() } -> std::same_as<std::size_t>;
  problems.solve(kernel, k, result);
  { problems.is_right(kernel, k, result) } -> std::same_as<bool>;
};

/// What is asked of a method where no bound is proved, in u times the scale of the result: half of the digits.
inline constexpr double half_of_the_digits = 0x1p26;

/// The race cells of a study of a companion problem, still without methods. Throws Failure(usage) for what is not
/// timed.
std::vector<RaceCell> companion_race_cells(const suite::Study& study, Problem problem, bool each_data);

/// One method on the problems of a race cell, and the results that it must reproduce bit for bit.
template <TimedCompanion P>
class CompanionRival {
 public:
  CompanionRival(const P& problems, const typename P::Kernel& kernel)
      : problems_(problems), kernel_(kernel), results_(problems.count()) {
    spoil();
    run();
    judged_ = results_;
    spoil();
  }
  void run() {
    for (std::size_t k = 0; k < results_.size(); ++k) problems_.solve(kernel_, k, results_[k]);
  }
  bool check() {
    const bool same = std::ranges::equal(results_, judged_, same_bits);
    spoil();
    return same;
  }
  [[nodiscard]] bool is_right() const {
    bool right = true;
    for (std::size_t k = 0; k < judged_.size(); ++k) right = right && problems_.is_right(kernel_, k, judged_[k]);
    return right;
  }

 private:
  using Result = typename P::Result;

  static bool same_bits(const Result& a, const Result& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
  }
  /// So that a run that does nothing cannot pass the next check.
  void spoil() {
    for (auto& result : results_) std::ranges::fill(result, std::numeric_limits<double>::quiet_NaN());
  }

  const P& problems_;
  const typename P::Kernel& kernel_;
  std::vector<Result> results_;
  std::vector<Result> judged_;
};

/// Of a problem that starts from data points, the degree is that of the curves that these are taken from.
template <TimedCompanion P>
std::vector<RaceCell> race_cells_of_companion(const suite::Study& study) {
  const auto chosen = judge::chosen_companions(study, P::problem);
  auto race_cells = companion_race_cells(study, P::problem, P::each_data);
  for (auto& race_cell : race_cells)
    for (const auto& kernel : P::kernels(race_cell.cell.dimension))
      if (std::ranges::count(chosen, kernel.info) > 0 && kernel.info->form == study.curve &&
          (P::each_data || kernel.info->template supports<double>(race_cell.cell.degree)))
        race_cell.methods.push_back(kernel.info);
  return race_cells;
}

template <TimedCompanion P>
JudgedRivals rivals_of_companion(const RaceCell& race_cell, const suite::Study& study, std::uint64_t seed) {
  const auto problems = std::make_shared<const P>(race_cell, study, seed);
  JudgedRivals all{{}, {}, problems};
  for (const auto* info : race_cell.methods) {
    const auto& kernel = *std::ranges::find(P::kernels(race_cell.cell.dimension), info, &P::Kernel::info);
    const auto contestant = std::make_shared<CompanionRival<P>>(*problems, kernel);
    all.right.push_back(contestant->is_right());
    all.rivals.push_back({std::string(info->id), problems->count(), [contestant] { contestant->run(); },
                          [contestant] { return contestant->check(); }});
  }
  return all;
}

template <TimedCompanion P>
constexpr TimedProblem timed_companion(Size size = Size::unclaimed) {
  return {P::problem, size, race_cells_of_companion<P>, rivals_of_companion<P>};
}

}  // namespace bezierbench::race
