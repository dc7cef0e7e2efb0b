// SPDX-License-Identifier: MIT
// The functions behind `Kernel::evaluate_for`, instantiated once for each evaluator, scalar and dimension; every path
// that ends in an evaluator shares them. Families of evaluators are compiled in units of their own.
#pragma once

#include <cstddef>
#include <span>

#include "core/evaluate/kernel_of.hpp"
#include "core/evaluate/roster.hpp"
#include "core/evaluate/via.hpp"

namespace bezierbench::instantiate {

enum class Family { triangle, bernstein, power, rational };

constexpr Family family_of(const MethodInfo& info) {
  if (info.form == Form::rational) return Family::rational;
  if (info.form != Form::bernstein) return Family::power;
  return info.cost_exponent > 1 ? Family::triangle : Family::bernstein;
}

/// The evaluators of a family, in roster order.
template <Family F, class EvaluatorList = Evaluators>
struct Members;
template <Family F, class... Es>
struct Members<F, TypeList<Es...>> {
  using Type = typename Concatenated<detail::OneIf<family_of(Es::info) == F, Es>...>::Type;
};

template <class Scalar>
using EvaluateFor = decltype(Kernel<Scalar>::evaluate_for);

/// One for each evaluator of the family, in roster order. Defined in the units of the families.
template <class Scalar, int Dimension, Family F>
std::span<const EvaluateFor<Scalar>> points_of_family();

/// The place of an evaluator in a list.
template <class E, class... Es>
constexpr std::size_t place_in(TypeList<Es...> /*list*/) {
  std::size_t place = 0;
  (void)((std::is_same_v<E, Es> || (++place, false)) || ...);
  return place;
}

/// That of one evaluator.
template <class E, class Scalar, int Dimension>
EvaluateFor<Scalar> points_of() {
  constexpr Family family = family_of(E::info);
  return points_of_family<Scalar, Dimension, family>()[place_in<E>(typename Members<family>::Type())];
}

}  // namespace bezierbench::instantiate
