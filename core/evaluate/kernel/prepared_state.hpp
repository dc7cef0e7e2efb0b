// SPDX-License-Identifier: MIT
// What a kernel prepared of one curve, in memory of its own.
#pragma once

#include <memory>
#include <new>
#include <span>

#include "core/evaluate/kernel/kernel.hpp"

namespace bezierbench {

/// Owns the prepared state of a curve; evaluating changes nothing. The kernel must outlive it, the curve need not.
template <class Scalar>
class PreparedState {
 public:
  PreparedState(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve)
      : kernel_(&kernel),
        evaluate_(kernel.evaluate_for(curve.degree)),
        memory_(::operator new (kernel.prepared_size, std::align_val_t{kernel.prepared_alignment}),
                Free{std::align_val_t{kernel.prepared_alignment}}) {
    kernel.prepare(curve, memory_.get());
  }
  PreparedState(const PreparedState&) = delete;
  PreparedState& operator=(const PreparedState&) = delete;
  PreparedState(PreparedState&&) noexcept = default;
  PreparedState& operator=(PreparedState&&) = delete;
  ~PreparedState() {
    if (memory_ != nullptr && kernel_->destroy != nullptr) kernel_->destroy(memory_.get());
  }

  [[nodiscard]] const Kernel<Scalar>& kernel() const { return *kernel_; }
  /// What the functions of Kernel::evaluate_for take.
  [[nodiscard]] const void* get() const { return memory_.get(); }
  /// points[k * dimension + axis] becomes the point at t[k].
  void evaluate(std::span<const Scalar> t, Scalar* points) const { evaluate_(get(), t, points); }

 private:
  struct Free {
    std::align_val_t alignment;
    void operator()(void* memory) const { ::operator delete(memory, alignment); }
  };

  const Kernel<Scalar>* kernel_;
  EvaluatePoints<Scalar> evaluate_;
  std::unique_ptr<void, Free> memory_;
};

}  // namespace bezierbench
