// SPDX-License-Identifier: MIT
// Prepared curves at many t, into arrays of the caller: by the batch kernel that is the best for this processor where the
// method has one, else by the method's own kernel. Both give the same bits.
#pragma once

#include <algorithm>
#include <cstddef>

#include "bindings/c/status.hpp"
#include "core/batch/batch.hpp"
#include "core/evaluate/kernel/kernel.hpp"

namespace bezierbench::c {

/// Copies numbers that are `from_step` apart to where they are `to_step` apart.
template <class Scalar>
void copy_strided(const Scalar* from, std::ptrdiff_t from_step, std::size_t count, Scalar* to, std::ptrdiff_t to_step) {
  if (from_step == 1 && to_step == 1)
    std::copy_n(from, count, to);
  else
    for (std::size_t k = 0; k < count; ++k, from += from_step, to += to_step) *to = *from;
}

/// What `find(target)` has for the best target of this processor that has something; else an empty one.
template <class Find>
auto on_best_target(const Find& find) {
  static const auto usable = batch::usable_targets();  // asking the processor takes microseconds
  for (const auto* target : usable)
    if (auto found = find(*target)) return found;
  return decltype(find(*usable.front())){};
}

/// How a method evaluates prepared curves of one degree.
template <class Scalar>
class Evaluation {
 public:
  /// With `most` points in a call.
  Evaluation(const Kernel<Scalar>& kernel, int degree, std::size_t most);

  /// Writes coordinate `axis` of the point at t[k * t_step] to out[k * steps.point + axis * steps.axis]; `prepared` is
  /// what the kernel's `prepare` filled.
  void operator()(const void* prepared, const Scalar* t, std::ptrdiff_t t_step, std::size_t count, Scalar* out,
                  const bb_strides& steps) const;

 private:
  std::ptrdiff_t dimension_;
  EvaluatePoints<Scalar> one_by_one_;
  batch::BatchKernel<Scalar> side_by_side_;
};

}  // namespace bezierbench::c
