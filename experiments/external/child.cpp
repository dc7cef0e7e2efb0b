// SPDX-License-Identifier: MIT
#include "experiments/external/child.hpp"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill is not in <csignal>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <system_error>
#include <thread>

#include "experiments/failure.hpp"

namespace bezierbench::external {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t max_errors = 4096;  // bytes of standard error that are kept

[[noreturn]] void cannot(std::string_view what) {
  throw Failure(
      Exit::environment,
      "no process can be started for an external method: {}: {}; use fewer --jobs or raise the limits (ulimit -u, -n)",
      what, std::generic_category().message(errno));
}

/// A file in memory that no other process can open.
class MemoryFile {
 public:
  explicit MemoryFile(const char* name) : number_(memfd_create(name, MFD_CLOEXEC)) {
    if (number_ < 0) cannot("memfd_create");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(number_); }

  [[nodiscard]] int number() const { return number_; }

  /// Writes all bytes and goes back to the first.
  void fill(std::string_view bytes) const {
    while (!bytes.empty()) {
      const auto written = write(number_, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR) cannot("write");
      if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    lseek(number_, 0, SEEK_SET);
  }
  [[nodiscard]] std::string contents(std::size_t max) const {
    const auto end = lseek(number_, 0, SEEK_END);
    std::string bytes(std::min(max, static_cast<std::size_t>(std::max<off_t>(end, 0))), '\0');
    std::size_t got = 0;
    while (got < bytes.size()) {
      const auto count = pread(number_, bytes.data() + got, bytes.size() - got, static_cast<off_t>(got));
      if (count <= 0 && errno != EINTR) break;
      got += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    bytes.resize(got);
    return bytes;
  }

 private:
  int number_;
};

/// Bytes of private writable memory of this process, which RLIMIT_DATA limits.
rlim_t data_bytes() {
  long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%*d %*d %*d %*d %*d %ld", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return static_cast<rlim_t>(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// Sets the hard limit as well, so that the code cannot raise it again.
void limit(decltype(RLIMIT_DATA) resource, rlim_t max) {
  rlimit now{};
  if (getrlimit(resource, &now) != 0) return;
  now.rlim_cur = now.rlim_max = std::min(max, now.rlim_max);
  setrlimit(resource, &now);
}

/// What the child does before the work.
void enter_child(const MemoryFile& in, const MemoryFile& out, const MemoryFile& errors, std::size_t max_output,
                 const Limits& limits, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(EXIT_FAILURE);  // it has ended already
  for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::set_terminate([] { std::abort(); });
  on_exit([](int code, void* /*nothing*/) { _exit(code); }, nullptr);  // before the exit handlers of the parent
  if (dup2(in.number(), STDIN_FILENO) < 0 || dup2(out.number(), STDOUT_FILENO) < 0 ||
      dup2(errors.number(), STDERR_FILENO) < 0)
    _exit(EXIT_FAILURE);
  constexpr unsigned first_other = STDERR_FILENO + 1;
  syscall(SYS_close_range, first_other, ~0U, 0U);
  constexpr rlim_t megabyte = 1 << 20;
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, max_output);
  limit(RLIMIT_DATA, data_bytes() + limits.megabytes * megabyte);
}

/// Waits until the child has ended by itself or must be ended; it is not reaped, so that its number stays its group's.
End wait_for(pid_t child, const Limits& limits, bool (*stop)()) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(limits.seconds);
  std::chrono::microseconds pause{100};
  constexpr std::chrono::microseconds longest{2000};
  siginfo_t ended{};
  while (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0) {
    if (stop != nullptr && stop()) return End::interrupted;
    if (Clock::now() >= deadline) return End::timed_out;
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, longest);
  }
  return End::exited;
}

}  // namespace

Ended run_in_child(const std::function<void()>& work, std::string_view input, std::size_t max_output,
                   const Limits& limits, bool (*stop)()) {
  const MemoryFile in("bezierbench-input");
  const MemoryFile out("bezierbench-output");
  const MemoryFile errors("bezierbench-errors");
  in.fill(input);
  signal(SIGCHLD, SIG_DFL);  // where the parent of this program ignored it, no exit status would be available
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) cannot("fork");
  if (child == 0) {
    enter_child(in, out, errors, max_output, limits, parent);
    work();
    _exit(EXIT_SUCCESS);  // without the parent's exit handlers and buffers
  }
  setpgid(child, child);  // as the child does: whoever is first
  Ended ended;
  ended.end = wait_for(child, limits, stop);
  kill(-child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (ended.end == End::exited) {
    ended.end = WIFSIGNALED(status) ? End::signalled : End::exited;
    ended.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  }
  ended.output = out.contents(max_output);
  ended.errors = errors.contents(max_errors);
  return ended;
}

int keep_output_for_answer() {
  const int answer = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  return answer;
}

void write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) _exit(EXIT_FAILURE);
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace bezierbench::external
