// SPDX-License-Identifier: MIT
#include "experiments/run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace bezierbench::run {
namespace {

constexpr std::chrono::milliseconds terminal_interval{200};
constexpr std::chrono::seconds plain_interval{10};

}  // namespace

Progress::Progress(double total, bool quiet)
    : total_(total), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_print_(start_) {}

Progress::~Progress() {
  if (!quiet_ && terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::add(double cost) {
  const std::lock_guard lock(mutex_);
  done_ += cost;
  const auto now = Clock::now();
  if (quiet_ || now - last_print_ < (terminal_ ? terminal_interval : Clock::duration(plain_interval))) return;
  last_print_ = now;
  print(now);
}

void Progress::print(Clock::time_point now) const {
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = elapsed * (total_ - done_) / done_;
  const auto line = fmt::format("{}{:3.0f} % done, {:.0f} s so far, about {:.0f} s left{}", terminal_ ? "\r" : "",
                                100 * done_ / total_, elapsed, left, terminal_ ? "\033[K" : "\n");
  std::fputs(line.c_str(), stderr);  // errors of writing are ignored
}

}  // namespace bezierbench::run
