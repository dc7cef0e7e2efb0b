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
