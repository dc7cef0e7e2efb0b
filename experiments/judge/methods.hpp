// SPDX-License-Identifier: MIT
// All methods of the problems that peers solve as well: our own methods and, in a build with peers, those of other
// libraries.
#pragma once

#include <span>
#include <string_view>

#include "core/arc_length/kernel.hpp"
#include "core/evaluate/kernel.hpp"
#include "core/project/kernel.hpp"

namespace bezierbench::judge {

/// Our own evaluators in roster order, then the peers, which exist in double only. Dimension is 1, 2 or 3.
template <class Scalar>
std::span<const Kernel<Scalar>> methods(int dimension);

/// Likewise for arc lengths and for projection.
std::span<const ArcLengthKernel> arc_length_methods(int dimension);
std::span<const ProjectionKernel> projection_methods(int dimension);

/// The info of every peer that is not an evaluator, each once, in roster order.
std::span<const MethodInfo* const> companion_peer_infos();

/// The entry for a method of this form; nullptr if there is none.
template <class Scalar>
const Kernel<Scalar>* find_method(std::string_view id, Form form, int dimension) {
  for (const auto& kernel : methods<Scalar>(dimension))
    if (kernel.info->id == id && kernel.info->form == form) return &kernel;
  return nullptr;
}

}  // namespace bezierbench::judge
