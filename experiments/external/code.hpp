// SPDX-License-Identifier: MIT
// Methods that are code: a plug-in, or a method that was compiled in. Both are called in child processes.
#pragma once

#include "experiments/external/child.hpp"
#include "experiments/external/method.hpp"

namespace bezierbench::external {

/// The kernel's `prepare` may throw this, where the method does not take the curve.
struct CurveRefused {};

/// A method that has kernels.
class Code : public Method {
 public:
  Code(const Limits& limits, bool (*stop)()) : limits_(limits), stop_(stop) {}

  [[nodiscard]] const suite::ExternalMethod& record() const final { return record_; }
  /// Each curve is prepared, evaluated and destroyed in turn.
  [[nodiscard]] Answer points(const Batch& batch) const final;
  [[nodiscard]] Limits limits() const final { return limits_; }

 protected:
  suite::ExternalMethod record_;
  Limits limits_;
  bool (*stop_)();
};

/// The status of a child that gave no answer.
Answer failed(const Ended& ended);

}  // namespace bezierbench::external
