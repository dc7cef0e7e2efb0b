// SPDX-License-Identifier: MIT
#include "experiments/run/progress_state.hpp"

#include <algorithm>
#include <utility>

namespace bezierbench::run {

ProgressState::ProgressState(std::vector<StudyWork> studies) : studies_(std::move(studies)), done_(studies_.size()) {
  for (const auto& study : studies_) {
    phases_.at(study.alone ? 1 : 0).total += study.cost;
    if (study.blocks == 0) ++studies_done_;
  }
}

void ProgressState::add(std::size_t study, double cost, double elapsed) {
  last_ = study;
  auto& done = done_.at(study);
  done.cost += cost;
  if (++done.blocks == studies_[study].blocks) ++studies_done_;
  auto& phase = phases_.at(studies_[study].alone ? 1 : 0);
  phase.done += cost;
  phase.seconds += std::max(elapsed - elapsed_, 0.0);
  elapsed_ = std::max(elapsed, elapsed_);
}

/// A phase that has not begun is expected to take what its cost says.
double ProgressState::left() const {
  constexpr double nanosecond = 1e-9;
  double seconds = 0;
  for (const auto& phase : phases_) {
    const double per_cost = phase.done > 0 ? phase.seconds / phase.done : nanosecond;
    seconds += per_cost * std::max(phase.total - phase.done, 0.0);
  }
  return seconds;
}

ProgressView ProgressState::view() const {
  const auto share = [](double done, double total) { return total > 0 ? std::min(done / total, 1.0) : 1.0; };
  ProgressView view;
  if (studies_.empty()) return view;
  view.study = studies_[last_].id;
  view.study_share = share(done_[last_].cost, studies_[last_].cost);
  view.share = share(phases_[0].done + phases_[1].done, phases_[0].total + phases_[1].total);
  view.studies_done = studies_done_;
  view.studies = studies_.size();
  view.elapsed = elapsed_;
  view.left = left();
  return view;
}

}  // namespace bezierbench::run
