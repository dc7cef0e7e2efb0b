// SPDX-License-Identifier: MIT
// Defines the functions of a unit; included by the units that instantiate them.
#pragma once

#include <array>

#include "core/evaluate/kernel/points/point_kernel.hpp"
#include "core/evaluate/kernel/points/point_units.hpp"

namespace bezierbench::instantiate {

template <class Scalar, int Dimension, class... Es>
std::span<const EvaluateFor<Scalar>> evaluate_functions(TypeList<Es...> /*evaluators*/) {
  static constexpr std::array<EvaluateFor<Scalar>, sizeof...(Es)> table{evaluate_for<Es, Scalar, Dimension>...};
  return table;
}

template <class Scalar, int Dimension, int Unit>
std::span<const EvaluateFor<Scalar>> unit_table() {
  return evaluate_functions<Scalar, Dimension>(Dealt<Unit, point_units, Evaluators>());
}

}  // namespace bezierbench::instantiate
