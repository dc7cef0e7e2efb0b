// SPDX-License-Identifier: MIT
#include "experiments/external/child.hpp"

#include <gtest/gtest.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill is not in <csignal>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
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
  for (const char* command : {"sleep 60 & echo $!; wait", "sleep 60 & echo $!"}) {
    const bool waits = std::string(command).ends_with("wait");
    const double seconds = waits ? 2 : 60;  // a shell that does not wait ends by itself, on a busy machine later
    const auto ended = run_in_child([command] { shell(command); }, {}, room, {.seconds = seconds}, nullptr);
    EXPECT_EQ(ended.end, waits ? End::timed_out : End::exited);
    EXPECT_TRUE(ends(static_cast<pid_t>(std::stol(ended.output)))) << command;
  }
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
