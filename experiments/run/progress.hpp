// SPDX-License-Identifier: MIT
// The progress of a run on standard error: one line that is rewritten on a terminal, or a line at intervals elsewhere.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/run.hpp"

namespace bezierbench::run {

// How far a run is, and how long it will take, from the work that is done and the time that it took.

/// The work that is left of a study when a run begins.
struct StudyWork {
  std::string id;
  std::uint64_t blocks = 0;
  double cost = 0;     ///< Job::cost of these blocks: nanoseconds of one thread, to an order of magnitude
  bool alone = false;  ///< for timings, which run after all other studies and one at a time
};

struct ProgressView {
  std::string study;  ///< of the last block
  double share = 0;   ///< of all work that is done
  std::size_t studies_done = 0;
  std::size_t studies = 0;
  double left = 0;  ///< seconds, estimated
};

class ProgressState {
 public:
  explicit ProgressState(std::vector<StudyWork> studies);

  /// A block of this study, of this cost, was done `elapsed` seconds after the beginning.
  void add(std::size_t study, double cost, double elapsed);
  [[nodiscard]] ProgressView view() const;

 private:
  /// Studies that run together. Their costs are compared with the time that they took, each phase with its own, since
  /// one has all threads and the other a single one.
  struct Phase {
    double total = 0;
    double done = 0;
    double seconds = 0;
  };

  [[nodiscard]] double left() const;

  std::vector<StudyWork> studies_;
  std::vector<std::uint64_t> blocks_done_;  ///< by study
  std::array<Phase, 2> phases_;             ///< all threads, then alone
  std::size_t last_ = 0;
  std::size_t studies_done_ = 0;
  double elapsed_ = 0;
};

class Progress {
 public:
  Progress(std::vector<StudyWork> studies, bool quiet);
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
  bool quiet_;
  bool terminal_;
  Clock::time_point start_;
  Clock::time_point last_print_;
  std::mutex mutex_;
};

/// A time for people: "48 s", "3 min 20 s", "2 h 05 min".
std::string duration(double seconds);

/// " 43 %, about 48 s left, 2.3.1-bezier (4 of 11 studies done)", without an end of line.
std::string progress_line(const ProgressView& view);

/// "complete in 48 s: 154 cells, no bound violated, 120 times, the intervals of their ratios 3.4 % wide in the
/// median"; without cells where `outcome` has
/// none.
std::string ending_line(const Outcome& outcome);

/// Writes one line to standard error, which a terminal gets broken at spaces, escaped by reference/number/echo.hpp. `head` is put before it, in colour on a terminal.
void note(const std::string& line, std::string_view head = {});

}  // namespace bezierbench::run
