// SPDX-License-Identifier: MIT
#include "experiments/run/interruption.hpp"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction is not in <csignal>
#include <unistd.h>

#include <atomic>
#include <string_view>

#include "experiments/failure.hpp"

namespace bezierbench::run {
namespace {

std::atomic<bool> arrived = false;  // set by a handler on any thread, read by all
std::atomic<bool> at_work = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may use it");

extern "C" void end_or_remember(int /*signal*/) {
  if (at_work.load(std::memory_order_relaxed)) return arrived.store(true, std::memory_order_relaxed);
  constexpr std::string_view line = "bezierbench: interrupted before any work began; run the same command again\n";
  // A line that cannot be written is ignored.
  (void)!::write(STDERR_FILENO, line.data(), line.size());
  ::_exit(static_cast<int>(Exit::interrupted));
}

}  // namespace

void watch_for_interruption() {
  struct sigaction action = {};
  action.sa_handler = end_or_remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void work_begins() { at_work.store(true, std::memory_order_relaxed); }

bool interrupted() { return arrived.load(std::memory_order_relaxed); }

}  // namespace bezierbench::run
