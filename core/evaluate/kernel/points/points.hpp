// SPDX-License-Identifier: MIT
// Defines the functions of a family of evaluators; included by the units that instantiate them.
#pragma once

#include <array>

#include "core/evaluate/kernel/points/point_families.hpp"
#include "core/evaluate/kernel/points/point_kernel.hpp"

namespace bezierbench::instantiate {

template <class Scalar, int Dimension, class... Es>
std::span<const EvaluateFor<Scalar>> evaluate_functions(TypeList<Es...> /*evaluators*/) {
  static constexpr std::array<EvaluateFor<Scalar>, sizeof...(Es)> table{evaluate_for<Es, Scalar, Dimension>...};
  return table;
}

template <class Scalar, int Dimension, KernelFamily F>
std::span<const EvaluateFor<Scalar>> family_table() {
  return evaluate_functions<Scalar, Dimension>(typename Members<F>::Type());
}

}  // namespace bezierbench::instantiate
