// SPDX-License-Identifier: MIT
#include "experiments/run/interruption.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>

#include "experiments/failure.hpp"

namespace bezierbench::run {
namespace {

/// How a process ended that did this; it gets no further than 10 seconds.
int status_of(const std::function<int()>& what) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(10);
    watch_for_interruption();
    _exit(what());
  }
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

TEST(Interruption, EndsWhatIsOnlyReading) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const int status = status_of([&] {
      raise(signal);
      return 0;
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(Exit::interrupted));
  }
}

TEST(Interruption, IsRememberedByWhatIsAtWork) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const int status = status_of([&] {
      work_begins("b: interrupted");
      const bool before = interrupted();
      raise(signal);
      return !before && interrupted() ? 0 : 1;
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
  }
}

TEST(Interruption, EndsWorkThatDoesNotEndWithinASecond) {
  const auto begin = std::chrono::steady_clock::now();
  const int status = status_of([] {
    work_begins("b: interrupted");
    raise(SIGINT);
    for (;;) pause();
    return 0;
  });
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(Exit::interrupted));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(Interruption, LeavesTimeToWhatEndsByItself) {
  const int status = status_of([] {
    work_begins("b: interrupted");
    raise(SIGINT);
    ends_by_itself();
    sleep(1);
    return 7;
  });
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(Interruption, TheSecondEndsWork) {
  const int status = status_of([] {
    work_begins("b: interrupted");
    raise(SIGTERM);
    raise(SIGTERM);
    return 0;
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGTERM);
}

}  // namespace
}  // namespace bezierbench::run
