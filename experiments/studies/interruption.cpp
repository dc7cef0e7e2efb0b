// SPDX-License-Identifier: MIT
#include "experiments/studies/interruption.hpp"

#include <csignal>

namespace bezierbench::studies {
namespace {

volatile std::sig_atomic_t arrived = 0;

extern "C" void remember(int signal) {
  arrived = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_for_interruption() {
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

bool interrupted() { return arrived != 0; }

}  // namespace bezierbench::studies
