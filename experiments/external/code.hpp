// SPDX-License-Identifier: MIT
// Methods that are code: a plug-in, or a method that was compiled in. Both are called in child processes.
#pragma once

#include "experiments/external/child.hpp"
#include "experiments/external/method.hpp"

namespace bezierbench::external {

/// The kernel's `prepare` may throw this, where the method does not take the curve.
struct CurveRefused {};

/// A method that has kernels, or solves other problems.
class Code : public Method {
 public:
  Code(const Limits& limits, bool (*stop)()) : limits_(limits), stop_(stop) {}

  [[nodiscard]] const suite::ExternalMethod& record() const final { return record_; }
  /// Each curve is prepared, evaluated and destroyed in turn.
  [[nodiscard]] Answer ask(const Batch& batch) const final;
  [[nodiscard]] Limits limits() const final { return limits_; }

 protected:
  /// The answers to a batch of another problem; called in a child process.
  virtual Status solve(const Batch& /*batch*/, std::vector<double>& /*numbers*/) const { return Status::refused; }

  suite::ExternalMethod record_;
  Limits limits_;
  bool (*stop_)();

 private:
  [[nodiscard]] Status answer(const Batch& batch, std::vector<double>& numbers) const;
};

/// The status of a child that gave no answer.
Answer failed(const Ended& ended);

}  // namespace bezierbench::external
