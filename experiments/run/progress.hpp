// SPDX-License-Identifier: MIT
// The progress of a run on standard error: one line that is rewritten on a terminal, or a line at intervals elsewhere.
#pragma once

#include <chrono>
#include <mutex>

namespace bezierbench::run {

class Progress {
 public:
  /// `total` in any unit of cost. Silent if `quiet`.
  Progress(double total, bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  ~Progress();

  /// Thread-safe.
  void add(double cost);

 private:
  using Clock = std::chrono::steady_clock;
  void print(Clock::time_point now) const;

  double total_;
  double done_ = 0;
  bool quiet_;
  bool terminal_;
  Clock::time_point start_;
  Clock::time_point last_print_;
  std::mutex mutex_;
};

}  // namespace bezierbench::run
