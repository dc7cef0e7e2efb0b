// SPDX-License-Identifier: MIT
// `Kernel::evaluate_for` of every evaluator, instantiated once for each scalar and dimension; every path that ends in
// an evaluator shares it. The evaluators are dealt out to several units.
#pragma once

#include <cstddef>
#include <span>

#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/evaluate/kernel/units.hpp"
#include "core/evaluate/roster.hpp"
#include "core/evaluate/via.hpp"

namespace bezierbench::instantiate {

/// The functions for one scalar type are compiled in so many units.
inline constexpr int point_units = 5;

template <class Scalar>
using EvaluateFor = decltype(Kernel<Scalar>::evaluate_for);

/// One for each evaluator of a unit, in roster order. Defined in the unit.
template <class Scalar, int Dimension, int Unit>
std::span<const EvaluateFor<Scalar>> unit_table();

/// `Kernel::evaluate_for` of one evaluator.
template <class E, class Scalar, int Dimension>
EvaluateFor<Scalar> evaluate_function() {
  constexpr std::size_t place = place_in<E>(Evaluators());
  return unit_table<Scalar, Dimension, place % point_units>()[place / point_units];
}

}  // namespace bezierbench::instantiate
