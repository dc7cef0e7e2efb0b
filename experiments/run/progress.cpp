// SPDX-License-Identifier: MIT
#include "experiments/run/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "experiments/run/progress_text.hpp"
#include "experiments/terminal.hpp"

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

namespace {

constexpr std::chrono::milliseconds terminal_interval{200};
constexpr std::chrono::seconds json_interval{1};
constexpr std::chrono::seconds plain_interval{10};

}  // namespace

Progress::Progress(std::vector<StudyWork> studies, Telling telling)
    : state_(std::move(studies)),
      telling_(telling),
      terminal_(telling == Telling::text && isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_print_(start_) {}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

Progress::Clock::duration Progress::interval() const {
  if (telling_ == Telling::json) return json_interval;
  return terminal_ ? Clock::duration(terminal_interval) : Clock::duration(plain_interval);
}

void Progress::add(std::size_t study, double cost) {
  const std::lock_guard lock(mutex_);
  state_.add(study, cost, seconds());
  if (telling_ == Telling::nothing) return;
  const auto now = Clock::now();
  const auto view = state_.view();
  const bool study_ends = telling_ == Telling::json && view.studies_done > studies_told_;
  if (!study_ends && now - last_print_ < interval()) return;
  last_print_ = now;
  studies_told_ = view.studies_done;
  print(view);
}

void Progress::print(const ProgressView& view) const {
  if (telling_ == Telling::json) return note_event(progress_json(view));
  auto line = progress_line(view);
  if (terminal_) {
    // A line that is broken by the terminal cannot be rewritten.
    if (const auto width = terminal_width(STDERR_FILENO)) line.resize(std::min(line.size(), *width - 1));
    line = '\r' + line + "\033[K";
  } else {
    line += '\n';
  }
  std::fputs(line.c_str(), stderr);  // errors of writing are ignored
}

}  // namespace bezierbench::run
