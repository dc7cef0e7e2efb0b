// SPDX-License-Identifier: MIT
// Stops computations of the truth. At high degrees they take minutes, so their loops ask whether the result is still
// wanted.
#pragma once

#include <exception>
#include <functional>
#include <utility>

namespace bezierbench::reference {

/// Thrown by a computation of the truth that was stopped.
class Stopped : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "the computation of the truth was stopped"; }
};

/// While an object lives, computations of the truth on its thread throw Stopped once `condition` is true. They evaluate
/// it at least ten times a second, most often thousands of times.
class StopWhen {
 public:
  explicit StopWhen(std::function<bool()> condition)
      : condition_(std::move(condition)), before_(std::exchange(innermost, this)) {}
  StopWhen(const StopWhen&) = delete;
  StopWhen& operator=(const StopWhen&) = delete;
  ~StopWhen() { innermost = before_; }

  /// Throws Stopped where a condition of this thread is true.
  static void poll() {
    for (const StopWhen* one = innermost; one != nullptr; one = one->before_)
      if (one->condition_()) throw Stopped();
  }

 private:
  inline static thread_local const StopWhen* innermost = nullptr;
  std::function<bool()> condition_;
  const StopWhen* before_;
};

}  // namespace bezierbench::reference
