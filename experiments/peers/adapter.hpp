// SPDX-License-Identifier: MIT
// Makes kernels of an adapter, by the same step as for our own methods.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/method.hpp"

namespace bezierbench::peers {

/// An adapter takes the dimensions that its `prepare` takes.
template <class Adapter, int Dimension>
concept Takes = requires(const Curve<Form::bernstein, double, Dimension>& curve) {
  Adapter::prepare(curve);
};

template <Evaluator Adapter, int Dimension>
std::span<const Kernel<double>> kernels_in() {
  if constexpr (Takes<Adapter, Dimension>) {
    static constexpr std::array table{instantiate::kernel<Adapter, double, Dimension>()};
    return table;
  } else {
    return {};
  }
}

/// The kernel of an adapter for this dimension, if it takes it.
template <Evaluator Adapter>
std::span<const Kernel<double>> kernels_of(int dimension) {
  switch (dimension) {
    case 1: return kernels_in<Adapter, 1>();
    case 2: return kernels_in<Adapter, 2>();
    case 3: return kernels_in<Adapter, 3>();
    default: return {};
  }
}

// What adapters for companion problems have in common.

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
