// SPDX-License-Identifier: MIT
// What adapters for companion problems have in common.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "core/method.hpp"

namespace bezierbench::peers {

/// The info of a method for Bezier curves of degree 1 to `max_degree` that is not bit-stable and has no bound.
constexpr MethodInfo companion_info(std::string_view id, std::string_view label, Problem problem,
                                    std::string_view citation, int max_degree = 100) {
  return {.id = id,
          .label = label,
          .problem = problem,
          .form = Form::bernstein,
          .min_degree = 1,
          .max_degree = max_degree,
          .bit_stable = false,
          .flops = "that of the library",
          .citation = citation};
}

/// The one of an adapter's kernels for this dimension, if there is one.
template <class K, std::size_t Count>
std::span<const K> in_dimension(const std::array<K, Count>& kernels, int dimension) {
  const auto* const found = std::ranges::find(kernels, dimension, &K::dimension);
  return {found, static_cast<std::size_t>(found == kernels.end() ? 0 : 1)};
}

}  // namespace bezierbench::peers
