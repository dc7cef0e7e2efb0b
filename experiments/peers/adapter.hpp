// SPDX-License-Identifier: MIT
// Makes kernels of an adapter, by the same step as for our own methods.
#pragma once

#include <array>
#include <span>
#include <utility>

#include "core/evaluate/kernel/kernel_of.hpp"

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

}  // namespace bezierbench::peers
