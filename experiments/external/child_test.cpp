// SPDX-License-Identifier: MIT
#include "experiments/external/child.hpp"

#include <gtest/gtest.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill is not in <csignal>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace bezierbench::external {
namespace {

constexpr std::size_t room = 1 << 16;

void shell(const char* command) { execl("/bin/sh", "sh", "-c", command, nullptr); }

TEST(Child, HandsOverInputOutputAndErrors) {
  const std::string input(200'000, 'x');
  const auto ended = run_in_child([] { shell("wc -c; echo sorry >&2; exit 7"); }, input, room, {}, nullptr);
  EXPECT_EQ(ended.end, End::exited);
  EXPECT_EQ(ended.code, 7);
  EXPECT_EQ(ended.output, "200000\n");
  EXPECT_EQ(ended.errors, "sorry\n");
}

TEST(Child, ReportsTheSignalThatEndsIt) {
  const auto ended = run_in_child([] { std::abort(); }, {}, room, {}, nullptr);
  EXPECT_EQ(ended.end, End::signalled);
  EXPECT_EQ(ended.code, SIGABRT);
}

TEST(Child, ReportsItsEndThoughChildrenWereIgnored) {
  signal(SIGCHLD, SIG_IGN);
  const auto ended = run_in_child([] { std::abort(); }, {}, room, {}, nullptr);
  signal(SIGCHLD, SIG_DFL);
  EXPECT_EQ(ended.end, End::signalled);
}

/// Waits until the process is gone; false after two seconds.
bool ends(pid_t process) {
  for (int k = 0; k < 200; ++k) {
    if (kill(process, 0) != 0 && errno == ESRCH) return true;
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(stat, text);
    if (text.find(") Z ") != std::string::npos) return true;  // nobody has asked for its exit code yet
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(Child, TakesItsOwnChildrenWithIt) {
  for (const char* command :
       {"sleep 60 & echo $!; wait", "sleep 60 & echo $!", "setsid sh -c 'sleep 60 & echo $!; wait' & wait",
        "setsid sh -c 'sleep 60 & echo $!' && sleep 0.1"}) {
    const auto ended = run_in_child([command] { shell(command); }, {}, room, {.seconds = 0.5}, nullptr);
    EXPECT_EQ(ended.end, std::string(command).ends_with("wait") ? End::timed_out : End::exited);
    EXPECT_TRUE(ends(static_cast<pid_t>(std::stol(ended.output)))) << command;
  }
}

/// Also where they leave their group one after the other, and their parents end.
TEST(Child, LeavesNoProcessBehind) {
  const auto work = [] {
    for (int k = 0; k < 40; ++k)
      if (fork() == 0) {
        setpgid(0, 0);
        if (k % 2 == 0 && fork() > 0) _exit(0);
        std::printf("%d\n", getpid());
        std::fflush(stdout);
        while (true) pause();
      }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  };
  const auto ended = run_in_child(work, {}, room, {}, nullptr);
  EXPECT_EQ(ended.end, End::exited);
  std::istringstream processes(ended.output);
  int count = 0;
  for (pid_t process = 0; processes >> process; ++count) EXPECT_TRUE(ends(process)) << process;
  EXPECT_GT(count, 20);
}

TEST(Child, EndsTheWardenAndNotTheRun) {
  const auto ended = run_in_child([] { kill(getppid(), SIGKILL), pause(); }, {}, room, {}, nullptr);
  EXPECT_EQ(ended.end, End::signalled);
  EXPECT_EQ(ended.code, SIGKILL);
}

TEST(Child, CannotRaiseItsLimits) {
  const auto work = [] {
    rlimit data{};
    getrlimit(RLIMIT_DATA, &data);
    _exit(data.rlim_max == data.rlim_cur && data.rlim_max != RLIM_INFINITY ? 0 : 1);
  };
  EXPECT_EQ(run_in_child(work, {}, room, {}, nullptr).code, 0);
}

TEST(Child, EndsWhenTheRunIsInterrupted) {
  const auto ended = run_in_child([] { pause(); }, {}, room, {.seconds = 60}, [] { return true; });
  EXPECT_EQ(ended.end, End::interrupted);
}

TEST(Child, WritesAndAllocatesWithinItsLimits) {
  const auto flood = run_in_child([] { shell("yes"); }, {}, room, {.seconds = 20}, nullptr);
  EXPECT_NE(flood.end, End::timed_out);
  EXPECT_LE(flood.output.size(), room);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which allocate in their own way
  const auto eat = [] {
    void* volatile block = std::malloc(std::size_t{1} << 30U);
    _exit(block == nullptr ? 3 : 0);
  };
  EXPECT_EQ(run_in_child(eat, {}, room, {.megabytes = 100}, nullptr).code, 3);
  EXPECT_EQ(run_in_child(eat, {}, room, {.megabytes = 2000}, nullptr).code, 0);
#endif
}

/// Exit handlers of this process must not run in a child that a method ends.
TEST(Child, RunsNoExitHandlerOfItsParent) {
  static bool in_child = false;
  std::atexit([] {
    if (in_child) std::abort();
  });
  const auto work = [] {
    in_child = true;
    std::exit(5);
  };
  const auto ended = run_in_child(work, {}, room, {}, nullptr);
  EXPECT_EQ(ended.end, End::exited);
  EXPECT_EQ(ended.code, 5);
}

TEST(Child, SeesNoFileOfItsParent) {
  std::FILE* const file = std::tmpfile();
  const int number = fileno(file);
  const auto ended = run_in_child([number] { _exit(write(number, "x", 1) == 1 ? 1 : 0); }, {}, room, {}, nullptr);
  EXPECT_EQ(ended.code, 0);
  std::fclose(file);
}

TEST(Child, ManyMayRunAtOnce) {
  std::vector<std::thread> threads;
  std::vector<std::string> outputs(8);
  for (std::size_t k = 0; k < outputs.size(); ++k)
    threads.emplace_back([&outputs, k] {
      const auto input = std::to_string(k);
      outputs[k] = run_in_child([] { shell("cat"); }, input, room, {}, nullptr).output;
    });
  for (auto& thread : threads) thread.join();
  for (std::size_t k = 0; k < outputs.size(); ++k) EXPECT_EQ(outputs[k], std::to_string(k));
}

}  // namespace
}  // namespace bezierbench::external
