// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/truth_option.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "experiments/echo.hpp"
#include "reference/stop.hpp"

namespace bezierbench::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int always_below = 21;  // of degrees at which it takes milliseconds, most often
constexpr std::chrono::seconds unasked{1};
constexpr std::chrono::seconds without_a_word{3};

}  // namespace

void TruthOption::add_to(Command command) {
  command.flag("--truth", wanted_, "wait for the exact result; default: for at most a second above degree 20");
}

bool TruthOption::finishes(const std::string& file, int degree, const std::function<void()>& compute) const {
  const auto begin = Clock::now();
  const bool limited = degree >= always_below && !wanted_;
  bool silent = true;
  const reference::StopWhen stop([&] {
    const auto taken = Clock::now() - begin;
    if (silent && !limited && taken >= without_a_word) {
      silent = false;
      fmt::print(stderr,
                 "bezierbench: {}: the exact result at degree {} takes more than {} seconds; Ctrl-C ends this\n",
                 printable(file), degree, without_a_word.count());
    }
    return limited && taken >= unasked;
  });
  try {
    compute();
    return true;
  } catch (const reference::Stopped&) {
    fmt::print(stderr,
               "bezierbench: {}: the exact result at degree {} takes more than a second, so its columns are empty; add "
               "--truth to compute it\n",
               printable(file), degree);
    return false;
  }
}

}  // namespace bezierbench::cli
