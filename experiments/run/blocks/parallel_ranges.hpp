// SPDX-License-Identifier: MIT
// oneTBB's parallel loop, in a form that the thread sanitizer can check.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <cstdint>
#include <functional>

namespace bezierbench::run {

/// Cuts 0, ..., size-1 into ranges and calls `run(begin, end)` for each, several at a time. Code before the call
/// happens before every range, and every range before code after the call.
class ParallelRanges {
 public:
  using Run = std::function<void(std::uint64_t begin, std::uint64_t end)>;

  explicit ParallelRanges(const Run& run) : run_(run) {}

  void over(std::uint64_t size) {
    begun_.store(true, std::memory_order_release);
    const AfterRanges after{ended_};
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, size), Body{this});
  }

 private:
  /// The only object in oneTBB's own memory; it is read here only. scripts/thread_sanitizer.supp names it.
  struct Body {
    ParallelRanges* self;
    void operator()(const tbb::blocked_range<std::uint64_t>& range) const { self->run_one(range.begin(), range.end()); }
  };

  // The library synchronises all this itself, but was not compiled with the sanitizer, which therefore does not see it.
  // The ranges are not ordered among each other: `ended_` is released to, never acquired, by them. Destructors
  // release and acquire, since an exception may end a range and the loop.
  struct RangeEnd {
    std::atomic<std::uint64_t>& ended;
    ~RangeEnd() { ended.fetch_add(1, std::memory_order_release); }
  };
  struct AfterRanges {
    const std::atomic<std::uint64_t>& ended;
    ~AfterRanges() { (void)ended.load(std::memory_order_acquire); }
  };

  void run_one(std::uint64_t begin, std::uint64_t end) {
    (void)begun_.load(std::memory_order_acquire);
    const RangeEnd at_end{ended_};
    run_(begin, end);
  }

  const Run& run_;
  std::atomic<bool> begun_{false};
  std::atomic<std::uint64_t> ended_{0};
};

inline void parallel_ranges(std::uint64_t size, const ParallelRanges::Run& run) { ParallelRanges(run).over(size); }

}  // namespace bezierbench::run
