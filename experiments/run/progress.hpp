// SPDX-License-Identifier: MIT
// The progress of a run on standard error: one line that is rewritten on a terminal, or a line at intervals elsewhere;
// or lines of JSON.
#pragma once

#include <chrono>
#include <mutex>
#include <vector>

#include "experiments/run/notes.hpp"
#include "experiments/run/progress_state.hpp"

namespace bezierbench::run {

class Progress {
 public:
  Progress(std::vector<StudyWork> studies, Telling telling);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  ~Progress();

  /// A block of this study is done. Thread-safe.
  void add(std::size_t study, double cost);
  [[nodiscard]] double seconds() const;  ///< since the beginning

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] Clock::duration interval() const;
  void print(const ProgressView& view) const;

  ProgressState state_;
  std::size_t studies_told_ = 0;
  Telling telling_;
  bool terminal_;
  Clock::time_point start_;
  Clock::time_point last_print_;
  std::mutex mutex_;
};

}  // namespace bezierbench::run
