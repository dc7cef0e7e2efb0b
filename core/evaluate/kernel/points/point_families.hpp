// SPDX-License-Identifier: MIT
// `Kernel::evaluate_for` of every evaluator, instantiated once for each scalar and dimension; every path that ends in
// an evaluator shares it. Each family of evaluators is compiled in units of its own.
#pragma once

#include <cstddef>
#include <span>

#include "core/evaluate/kernel/family.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/evaluate/roster.hpp"
#include "core/evaluate/via.hpp"

namespace bezierbench::instantiate {

/// The evaluators of a family, in roster order.
template <KernelFamily F, class EvaluatorList = Evaluators>
struct Members;
template <KernelFamily F, class... Es>
struct Members<F, TypeList<Es...>> {
  using Type = typename Concatenated<detail::OneIf<family_of(Es::info) == F, Es>...>::Type;
};

template <class Scalar>
using EvaluateFor = decltype(Kernel<Scalar>::evaluate_for);

/// One for each evaluator of the family, in roster order. Defined in the units of the families.
template <class Scalar, int Dimension, KernelFamily F>
std::span<const EvaluateFor<Scalar>> family_table();

/// The place of an evaluator in a list.
template <class E, class... Es>
constexpr std::size_t place_in(TypeList<Es...> /*list*/) {
  std::size_t place = 0;
  (void)((std::is_same_v<E, Es> || (++place, false)) || ...);
  return place;
}

/// `Kernel::evaluate_for` of one evaluator.
template <class E, class Scalar, int Dimension>
EvaluateFor<Scalar> evaluate_function() {
  constexpr KernelFamily family = family_of(E::info);
  return family_table<Scalar, Dimension, family>()[place_in<E>(typename Members<family>::Type())];
}

}  // namespace bezierbench::instantiate
