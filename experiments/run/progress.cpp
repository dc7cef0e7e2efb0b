// SPDX-License-Identifier: MIT
#include "experiments/run/progress.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::run {

ProgressState::ProgressState(std::vector<StudyWork> studies)
    : studies_(std::move(studies)), blocks_done_(studies_.size()) {
  for (const auto& study : studies_) {
    phases_.at(study.alone ? 1 : 0).total += study.cost;
    if (study.blocks == 0) ++studies_done_;
  }
}

void ProgressState::add(std::size_t study, double cost, double elapsed) {
  last_ = study;
  if (++blocks_done_.at(study) == studies_[study].blocks) ++studies_done_;
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
  view.share = share(phases_[0].done + phases_[1].done, phases_[0].total + phases_[1].total);
  view.studies_done = studies_done_;
  view.studies = studies_.size();
  view.left = left();
  return view;
}

namespace {

constexpr std::chrono::milliseconds terminal_interval{200};
constexpr std::chrono::seconds plain_interval{10};

}  // namespace

Progress::Progress(std::vector<StudyWork> studies, bool quiet)
    : state_(std::move(studies)),
      quiet_(quiet),
      terminal_(!quiet && isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_print_(start_) {}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

Progress::Clock::duration Progress::interval() const {
  return terminal_ ? Clock::duration(terminal_interval) : Clock::duration(plain_interval);
}

void Progress::add(std::size_t study, double cost) {
  const std::lock_guard lock(mutex_);
  state_.add(study, cost, seconds());
  const auto now = Clock::now();
  if (quiet_ || now - last_print_ < interval()) return;
  last_print_ = now;
  print(state_.view());
}

void Progress::print(const ProgressView& view) const {
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

namespace {

std::string_view word_of(Ending ending) {
  switch (ending) {
    case Ending::complete: return "complete";
    case Ending::partial: return "partial";
    case Ending::nothing_to_do: return "nothing_to_do";
  }
  return "";
}

/// "bounds violated 7 times, 2 proofs refuted"
std::string broken(const Outcome& outcome) {
  std::vector<std::string> parts;
  if (outcome.violations > 0) parts.push_back(fmt::format("bounds violated {} times", outcome.violations));
  if (outcome.broken_promises > 0) parts.push_back(fmt::format("promises broken {} times", outcome.broken_promises));
  if (outcome.refuted_proofs > 0)
    parts.push_back(fmt::format("{} proof{} refuted", outcome.refuted_proofs, outcome.refuted_proofs == 1 ? "" : "s"));
  return parts.empty() ? "no bound violated" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string duration(double seconds) {
  constexpr std::int64_t minute = 60;
  constexpr std::int64_t hour = 3600;
  constexpr double longest = 1e15;
  const auto whole = static_cast<std::int64_t>(std::llround(std::fmin(seconds, longest)));
  if (whole < minute) return fmt::format("{} s", whole);
  if (whole < hour) return fmt::format("{} min {:02} s", whole / minute, whole % minute);
  return fmt::format("{} h {:02} min", whole / hour, whole % hour / minute);
}

std::string progress_line(const ProgressView& view) {
  constexpr double percent = 100;
  // 100 % is left to the end of the run: a last block may still be under way.
  return fmt::format("{:3.0f} %, about {} left, {} ({} of {} studies done)", std::floor(percent * view.share),
                     duration(view.left), view.study, view.studies_done, view.studies);
}

std::string ending_line(const Outcome& outcome) {
  constexpr double percent = 100;
  auto line = fmt::format("{} in {}: {} cell{}, ", word_of(outcome.ending), duration(outcome.seconds), outcome.cells,
                          outcome.cells == 1 ? "" : "s");
  line += broken(outcome);
  if (outcome.times > 0)
    line += fmt::format(", {} times, the intervals of their ratios {:.2g} % wide in the median", outcome.times,
                        percent * outcome.ratio_width);
  return line;
}

void note(const std::string& line, std::string_view head) {
  constexpr std::size_t indent = 4;
  const auto width = isatty(STDERR_FILENO) != 0 ? terminal_width(STDERR_FILENO) : std::nullopt;
  const auto text = wrapped(head, printable(line), indent, width.value_or(SIZE_MAX));
  const auto shown = head.empty() ? std::string() : styled(STDERR_FILENO, fmt::fg(fmt::terminal_color::red), head);
  std::fputs((shown + text.substr(head.size())).c_str(), stderr);
}

}  // namespace bezierbench::run
