// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/limits.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include "experiments/failure.hpp"
#include "reference/exhausted_memory.hpp"

namespace bezierbench::cli {
namespace {

constexpr rlim_t least_stack = 4U << 20U;  // oneTBB's size for threads that do the same work
constexpr rlim_t usual_stack = 8U << 20U;
constexpr rlim_t least_memory = 64U << 20U;  // the program with its libraries, and room in which these begin

std::terminate_handler terminate_before = nullptr;
std::uintptr_t top_of_stack = 0;

/// Writes one line without allocating memory, and ends the program with all its threads.
[[noreturn]] void end_with(std::string_view reason) {
  static std::atomic_flag told;
  while (told.test_and_set()) pause();  // another thread prints its reason
  constexpr std::string_view program = "bezierbench: ";
  constexpr std::string_view advice =
      "; raise its limit (ulimit -v, -s, -u), use fewer --jobs, or ask for less at once\n";
  std::array<iovec, 3> parts{};
  std::size_t k = 0;
  for (const auto part : {program, reason, advice}) parts.at(k++) = {const_cast<char*>(part.data()), part.size()};
  [[maybe_unused]] const auto written = writev(STDERR_FILENO, parts.data(), static_cast<int>(parts.size()));
  _exit(static_cast<int>(Exit::environment));
}

/// Called when an exception leaves a function that must not throw, as in oneTBB when it cannot start a thread.
[[noreturn]] void terminated() {
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const std::runtime_error& error) {
    end_with(error.what());
  } catch (...) {  // a bug in this program
  }
  terminate_before();
  std::abort();
}

/// Handles a segmentation fault. One near the stack of the main thread means that the stack could not grow when it was
/// used.
void faulted(int signal, siginfo_t* info, void* /*context*/) {
  constexpr std::uintptr_t most_stack = 1U << 30U;
  const auto at = reinterpret_cast<std::uintptr_t>(info->si_addr);
  if (at < top_of_stack && top_of_stack - at < most_stack) end_with("memory is exhausted, or the stack");
  std::signal(signal, SIG_DFL);  // a bug: the instruction faults again
}

void watch_stack() {
  static std::array<std::byte, 1U << 15U> place;  // the handler's stack
  stack_t stack{};
  stack.ss_sp = place.data();
  stack.ss_size = place.size();
  struct sigaction action {};
  action.sa_sigaction = faulted;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  if (sigaltstack(&stack, nullptr) == 0) sigaction(SIGSEGV, &action, nullptr);
}

}  // namespace

void require_stack() {
  rlimit stack{};
  if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= least_stack) return;
  const auto allowed = stack.rlim_cur;
  stack.rlim_cur = std::min(stack.rlim_max, usual_stack);
  if (stack.rlim_cur >= least_stack && setrlimit(RLIMIT_STACK, &stack) == 0) return;
  throw Failure(Exit::environment, fmt::format("the stack is limited to {} KiB; allow {} KiB or more (ulimit -s)",
                                               allowed / 1024, least_stack / 1024));
}

void require_memory() {
  rlimit memory{};
  if (getrlimit(RLIMIT_AS, &memory) != 0 || memory.rlim_cur >= least_memory) return;
  throw Failure(Exit::environment, fmt::format("memory is limited to {} KiB; allow {} KiB or more (ulimit -v)",
                                               memory.rlim_cur / 1024, least_memory / 1024));
}

void report_exhausted_memory() {
  const char here = 0;
  top_of_stack = reinterpret_cast<std::uintptr_t>(&here);
  reference::on_exhausted_memory([] { end_without_memory(); });
  terminate_before = std::set_terminate(terminated);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // sanitizers report more about a fault
  watch_stack();
#endif
}

void end_without_memory() { end_with("memory is exhausted"); }

void end_without_resource(std::string_view reason) { end_with(reason); }

}  // namespace bezierbench::cli
