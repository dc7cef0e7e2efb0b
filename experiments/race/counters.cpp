// SPDX-License-Identifier: MIT
#include "experiments/race/counters.hpp"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace bezierbench::race {
namespace {

/// A file descriptor, or -1 with errno. `group` is that of the leader, or -1 for the leader itself.
int open_counter(std::uint64_t event, int group) {
  perf_event_attr wanted{};
  wanted.type = PERF_TYPE_HARDWARE;
  wanted.size = sizeof wanted;
  wanted.config = event;
  wanted.exclude_kernel = 1;
  wanted.exclude_hv = 1;
  wanted.read_format = PERF_FORMAT_GROUP | PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
  constexpr int this_thread = 0;
  constexpr int any_processor = -1;
  return static_cast<int>(
      syscall(SYS_perf_event_open, &wanted, this_thread, any_processor, group, PERF_FLAG_FD_CLOEXEC));
}

std::string reason_of(int error) {
  switch (error) {
    case ENOENT:
    case ENODEV:
    case EOPNOTSUPP: return "no such counters on this processor, as on many virtual machines";
    case EACCES:
    case EPERM: return "not permitted; set kernel.perf_event_paranoid to 2 or less, or loosen the container";
    case ENOSYS: return "no perf_event_open in this system";
    default: return std::generic_category().message(error);
  }
}

}  // namespace

std::optional<Counts> counts_between(const CounterReading& before, const CounterReading& after) {
  const auto running = static_cast<double>(after.running_ns - before.running_ns);
  const auto enabled = static_cast<double>(after.enabled_ns - before.enabled_ns);
  if (running <= 0) return std::nullopt;
  const double scale = enabled / running;
  return Counts{static_cast<double>(after.cycles - before.cycles) * scale,
                static_cast<double>(after.instructions - before.instructions) * scale};
}

Counters::Counters() {
  const std::string fault = open();
  state_ = fault.empty() ? "cycles, instructions" : "unavailable: " + fault;
  if (!fault.empty()) close();
}

Counters::~Counters() { close(); }

std::string Counters::open() {
  group_ = open_counter(PERF_COUNT_HW_CPU_CYCLES, -1);
  if (group_ < 0) return reason_of(errno);
  instructions_ = open_counter(PERF_COUNT_HW_INSTRUCTIONS, group_);
  if (instructions_ < 0) return reason_of(errno);
  const auto before = read();
  const auto after = read();  // the call itself takes some cycles of this thread
  return before && after && after->cycles != before->cycles ? "" : "they do not count";
}

void Counters::close() {
  for (int* counter : {&instructions_, &group_})
    if (*counter >= 0) ::close(std::exchange(*counter, -1));
}

std::optional<CounterReading> Counters::read() const {
  CounterReading reading;
  if (!available() || ::read(group_, &reading, sizeof reading) != sizeof reading) return std::nullopt;
  return reading;
}

}  // namespace bezierbench::race
