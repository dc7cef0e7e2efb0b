// SPDX-License-Identifier: MIT
// The evaluators that have batch kernels: those of the roster with a member `lanes`. They exist on every target, for
// every path that ends in the evaluator, in float and double and in 1 to 3 dimensions: one curve at many t, and many
// curves at one t each.
#pragma once

#include <type_traits>

#include "core/convert/differences.hpp"
#include "core/convert/differences_centered.hpp"
#include "core/convert/factorial.hpp"
#include "core/convert/forward_substitution.hpp"
#include "core/convert/positive_sum.hpp"
#include "core/convert/triangle.hpp"
#include "core/evaluate/kernel/units.hpp"
#include "core/evaluate/roster.hpp"

namespace bezierbench::batch {

namespace detail {

template <class E>
inline constexpr bool has_lanes = requires {
  E::lanes;
};

template <class E>
constexpr bool has_groups() {
  if constexpr (has_lanes<E>)
    return !E::lanes.one_curve_only;
  else
    return false;
}

template <class List>
struct Kept;
template <class... Es>
struct Kept<TypeList<Es...>> {
  using WithLanes = typename Concatenated<std::conditional_t<has_lanes<Es>, TypeList<Es>, TypeList<>>...>::Type;
  using WithGroups = typename Concatenated<std::conditional_t<has_groups<Es>(), TypeList<Es>, TypeList<>>...>::Type;
};

template <class E, class... Es>
constexpr bool is_one_of(TypeList<Es...> /*evaluators*/) {
  return (std::is_same_v<E, Es> || ...);
}

template <class E>
constexpr bool takes_rational() {
  if constexpr (E::info.form == Form::bernstein)
    return is_one_of<Homogeneous<E>>(Evaluators());
  else
    return false;
}

}  // namespace detail

/// The evaluators with kernels for one curve, and for many curves.
using OneCurve = detail::Kept<Evaluators>::WithLanes;
using ManyCurves = detail::Kept<Evaluators>::WithGroups;

/// The kernels for one target and scalar type are compiled in so many units, each of some seconds.
inline constexpr int units = 5;

/// True where the evaluator takes rational curves, too, by their homogeneous coordinates.
template <class E>
inline constexpr bool takes_rational = detail::takes_rational<E>();

/// Whether a kernel for one axis evaluates all axes in turn. It does for triangles, whose axes share only t.
template <class E>
inline constexpr bool axis_by_axis = PreparesNothing<E>&& E::info.form == Form::bernstein&& E::info.cost_exponent > 1;

/// The conversions with kernels for many curves. The exact ones are integers.
using ConversionsOfGroups =
    TypeList<Factorial, Differences, DifferencesCentered, ForwardSubstitution, PositiveSum, Triangle>;

}  // namespace bezierbench::batch
