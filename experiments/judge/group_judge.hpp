// SPDX-License-Identifier: MIT
// Judges trials of a cell of an accuracy study, a group at a time: draws them, evaluates every method, and adds the
// errors from every baseline to a tally.
#pragma once

#include <cstdint>
#include <span>

#include "experiments/judge/cell_tally.hpp"
#include "experiments/judge/judged_methods.hpp"
#include "experiments/sample/draw.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::judge {

/// Which trial of which replicate.
struct TrialNumber {
  std::int64_t replicate;
  std::int64_t trial;
};

/// Keeps references to the arguments of its constructor. Safe to use from several threads.
template <class Scalar>
class GroupJudge {
 public:
  /// The number of audited trials of replicate 0: their points in long double are compared with the truth.
  GroupJudge(const suite::Study& study, const sample::Cell& cell, const sample::Sampler& sampler,
             const JudgedMethods<Scalar>& methods, reference::Tier tier, std::int64_t audited_trials)
      : study_(study),
        cell_(cell),
        sampler_(sampler),
        methods_(methods),
        tier_(tier),
        audited_trials_(audited_trials) {}

  /// `count` trials from `first` on, at most trials_at_once. With `check`, the methods' own kernels evaluate the first
  /// one as well; a bit that differs throws std::logic_error.
  void judge(TrialNumber first, std::int64_t count, bool check, CellTally& block) const;
  /// Judges given points of the only method, point by point, which were computed elsewhere.
  void judge(TrialNumber first, std::span<const double> given, CellTally& block) const;

 private:
  struct Lane;
  struct Scratch;
  struct Origin;
  using Group = std::span<Lane>;

  void draw(Group group, TrialNumber first, Scratch& scratch) const;
  /// Judges a group; `evaluate` computes the points of every method, or takes given ones.
  template <class Evaluate>
  void judge_group(TrialNumber first, std::int64_t count, CellTally& block, const Evaluate& evaluate) const;
  void find_scales(Group group, Scratch& scratch) const;
  void find_truth(Group group, Scratch& scratch) const;
  void measure_from_truth(Group group, Scratch& scratch) const;
  void measure_from(const GroupMethod<Scalar>& baseline, Group group, Scratch& scratch) const;
  void judge_method(std::size_t method, Group group, Scratch& scratch, Judgement& judgement) const;
  [[nodiscard]] double distance(const Origin& from, Lane& lane, std::size_t number,
                                std::span<const double> point) const;
  void take_apart(std::size_t method, Lane& lane, std::span<const double> point, SourceMeter<Scalar>& sources,
                  Judgement& judgement) const;
  void add_truth(Group group, Scratch& scratch, CellTally& block) const;
  void compare_with_bound(std::size_t method, double error, Lane& lane, double length, Judgement& judgement) const;

  const suite::Study& study_;
  const sample::Cell& cell_;
  const sample::Sampler& sampler_;
  const JudgedMethods<Scalar>& methods_;
  reference::Tier tier_;
  std::int64_t audited_trials_;
};

}  // namespace bezierbench::judge
