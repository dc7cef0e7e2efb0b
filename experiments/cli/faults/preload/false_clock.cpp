// SPDX-License-Identifier: MIT
// To be preloaded (LD_PRELOAD) into the program under test: makes its monotonic clock wrong. FALSE_CLOCK is one of
//   stands   it never moves
//   back     every reading lies before the last
//   coarse   it moves every 10 milliseconds
#include <dlfcn.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace {

constexpr long ns_per_second = 1'000'000'000;
constexpr long coarse_step_ns = 10'000'000;

bool is_asked_for(const char* fault) {
  const char* asked = std::getenv("FALSE_CLOCK");
  return asked != nullptr && std::strcmp(asked, fault) == 0;
}

}  // namespace

extern "C" int clock_gettime(clockid_t which, timespec* time) noexcept {
  constexpr long start_seconds = 1'000'000;
  static std::atomic<long> readings{0};
  // The C library's reads the clock without a system call, which takes more than a microsecond on some machines.
  using Clock = int (*)(clockid_t, timespec*);
  static const auto right_clock = reinterpret_cast<Clock>(dlsym(RTLD_NEXT, "clock_gettime"));
  const int result = right_clock(which, time);
  if (which != CLOCK_MONOTONIC || result != 0) return result;
  if (is_asked_for("stands")) *time = {start_seconds, 0};
  if (is_asked_for("back")) {
    const long ns = start_seconds - ++readings;
    *time = {ns / ns_per_second + start_seconds, ns % ns_per_second};
  }
  if (is_asked_for("coarse")) time->tv_nsec -= time->tv_nsec % coarse_step_ns;
  return 0;
}
