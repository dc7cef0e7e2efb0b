// SPDX-License-Identifier: MIT
#include "experiments/studies/interruption.hpp"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction is not in <csignal>

#include <atomic>

namespace bezierbench::studies {
namespace {

std::atomic<bool> arrived = false;  // set by a handler on any thread, read by all
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may use it");

extern "C" void remember(int /*signal*/) { arrived.store(true, std::memory_order_relaxed); }

}  // namespace

void watch_for_interruption() {
  struct sigaction action = {};
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return arrived.load(std::memory_order_relaxed); }

}  // namespace bezierbench::studies
