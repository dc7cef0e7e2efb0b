// SPDX-License-Identifier: MIT
// Scratch memory that a thread reuses from trial to trial.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "core/evaluate/kernel/kernel.hpp"

namespace bezierbench::judge {

/// Room for the prepared state of any kernel.
class PreparedStorage {
 public:
  /// At least `size` bytes; the contents are lost.
  void* reserve(std::size_t size) {
    if (size > size_) {
      bytes_.reset(static_cast<std::byte*>(::operator new(size, alignment)));
      size_ = size;
    }
    return bytes_.get();
  }

 private:
  static constexpr std::align_val_t alignment{64};
  struct Free {
    void operator()(std::byte* bytes) const { ::operator delete(bytes, alignment); }
  };
  std::unique_ptr<std::byte, Free> bytes_;
  std::size_t size_ = 0;
};

/// Prepares and evaluates at one t; writes `dimension` coordinates.
template <class Scalar>
void evaluate_once(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve, Scalar t, PreparedStorage& storage,
                   std::span<Scalar> point) {
  void* prepared = storage.reserve(kernel.prepared_size);
  kernel.prepare(curve, prepared);
  kernel.evaluate_for(curve.degree)(prepared, std::span<const Scalar>(&t, 1), point.data());
  if (kernel.destroy != nullptr) kernel.destroy(prepared);
}

}  // namespace bezierbench::judge
