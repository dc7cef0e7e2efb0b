// SPDX-License-Identifier: MIT
// All evaluators of this build: our own and, where it was configured so, those of other libraries.
#pragma once

#include <span>
#include <string_view>

#include "core/evaluate/kernel.hpp"

namespace bezierbench::studies {

/// Our own in roster order, then the peers, which exist in double only. Dimension is 1, 2 or 3.
template <class Scalar>
std::span<const Kernel<Scalar>> methods(int dimension);

/// The entry for a method of this form; nullptr if there is none.
template <class Scalar>
const Kernel<Scalar>* find_method(std::string_view id, Form form, int dimension) {
  for (const auto& kernel : methods<Scalar>(dimension))
    if (kernel.info->id == id && kernel.info->form == form) return &kernel;
  return nullptr;
}

}  // namespace bezierbench::studies
