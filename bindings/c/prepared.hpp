// SPDX-License-Identifier: MIT
// A curve as a method prepared it.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <span>

#include "core/evaluate/kernel.hpp"

namespace bezierbench::c {

/// Owns the prepared state of one curve; evaluating changes nothing.
template <class Scalar>
class Prepared {
 public:
  Prepared(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve)
      : kernel_(&kernel),
        state_(::operator new (kernel.prepared_size, std::align_val_t{kernel.prepared_alignment}),
               Free{std::align_val_t{kernel.prepared_alignment}}) {
    kernel.prepare(curve, state_.get());
  }

  [[nodiscard]] const MethodInfo& info() const { return *kernel_->info; }
  void evaluate(std::span<const Scalar> t, Scalar* points) const { kernel_->evaluate(state_.get(), t, points); }

 private:
  struct Free {
    std::align_val_t alignment;
    void operator()(void* state) const { ::operator delete(state, alignment); }
  };

  const Kernel<Scalar>* kernel_;
  std::unique_ptr<void, Free> state_;
};

}  // namespace bezierbench::c
