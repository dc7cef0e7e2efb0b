// SPDX-License-Identifier: MIT
#include "experiments/run/interruption.hpp"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction is not in <csignal>
#include <time.h>    // NOLINT(modernize-deprecated-headers): likewise timer_create
#include <unistd.h>

#include <atomic>
#include <string>

#include "experiments/failure.hpp"

namespace bezierbench::run {
namespace {

std::atomic<bool> arrived = false;  // set by a handler on any thread, read by all
std::atomic<bool> at_work = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may use it");

std::string last_line = "bezierbench: interrupted; run the same command again\n";
timer_t time_left;  // ends the program that was to end by itself

extern "C" void end(int /*signal*/) {
  // A line that cannot be written is ignored.
  (void)!::write(STDERR_FILENO, last_line.data(), last_line.size());
  ::_exit(static_cast<int>(Exit::interrupted));
}

extern "C" void end_or_remember(int signal) {
  if (!at_work.load(std::memory_order_relaxed)) end(signal);
  arrived.store(true, std::memory_order_relaxed);
  constexpr itimerspec most_of_a_second{.it_interval = {}, .it_value = {.tv_sec = 0, .tv_nsec = 700'000'000}};
  ::timer_settime(time_left, 0, &most_of_a_second, nullptr);
}

}  // namespace

void watch_for_interruption() {
  struct sigaction action = {};
  sigemptyset(&action.sa_mask);
  action.sa_handler = end;
  sigaction(SIGALRM, &action, nullptr);
  timer_create(CLOCK_MONOTONIC, nullptr, &time_left);  // sends SIGALRM
  action.sa_handler = end_or_remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void work_begins(std::string_view line) {
  last_line = "bezierbench: " + std::string(line) + "\n";
  at_work.store(true, std::memory_order_relaxed);
}

void ends_by_itself() {
  constexpr itimerspec never{};
  ::timer_settime(time_left, 0, &never, nullptr);
}

bool interrupted() { return arrived.load(std::memory_order_relaxed); }

}  // namespace bezierbench::run
