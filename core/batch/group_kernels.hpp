// SPDX-License-Identifier: MIT
// Kernels for many curves at once, each with a t of its own, for the target that the including translation unit is
// compiled for.
#pragma once

#include "core/batch/lanes.hpp"
#include "core/batch/roster.hpp"
#include "core/batch/target_table.hpp"
#include "core/batch/targets.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

/// The number of vectors that a group has, but at most two, so that the methods' arrays of them stay in the first
/// cache.
template <class S>
using GroupLanes = Lanes<S, (2 * Lanes<S, 1>::size <= curves_at_once ? 2 : 1), Held::by_value>;

/// As many curves of a group as a vector has lanes. `others` is the number of axes that are skipped after each control
/// point.
template <Form F, class S, int Dimension>
HWY_INLINE Curve<F, GroupLanes<S>, Dimension> load_group(int degree, const S* coefficients, std::size_t others = 0) {
  using L = GroupLanes<S>;
  Curve<F, L, Dimension> curve(degree);
  if constexpr (F == Form::power_double_double) {
    const std::size_t lows = static_cast<std::size_t>(degree + 1) * Dimension * curves_at_once;
    curve.high = load_group<Form::power, S, Dimension>(degree, coefficients);
    curve.low = load_group<Form::power, S, Dimension>(degree, coefficients + lows);
  } else {
    for (int i = 0; i <= degree; ++i, coefficients += others * curves_at_once)
      for (int axis = 0; axis < Dimension; ++axis, coefficients += curves_at_once)
        curve(axis, i) = L::load(coefficients);
  }
  return curve;
}

template <class E, class S, int Dimension>
[[gnu::flatten, gnu::noinline]] void evaluate_lanes(int degree, const S* coefficients, std::size_t others, const S* t,
                                                    S* points) {
  using L = GroupLanes<S>;
  const Point<L, Dimension> point =
      E::evaluate(E::prepare(load_group<E::info.form, S, Dimension>(degree, coefficients, others)), L::load(t));
  for (int axis = 0; axis < Dimension; ++axis)
    point[axis].store(points + static_cast<std::size_t>(axis) * curves_at_once);
}

template <class E, class S, int Dimension>
void evaluate_group(int degree, const S* coefficients, const S* t, S* points) {
  constexpr int at_once = axis_by_axis<E> ? 1 : Dimension;
  for (int axis = 0; axis < Dimension; axis += at_once) {
    for (std::size_t k = 0; k < curves_at_once; k += GroupLanes<S>::size)
      evaluate_lanes<E, S, at_once>(degree, coefficients + k, Dimension - at_once, t + k, points + k);
    coefficients += curves_at_once;
    points += curves_at_once;
  }
}

template <class C, class S, int Dimension>
[[gnu::flatten]] void convert_lanes(int degree, const S* given, S* converted) {
  const auto curve = C::convert(load_group<C::info.form, S, Dimension>(degree, given));
  for (int i = 0; i <= degree; ++i)
    for (int axis = 0; axis < Dimension; ++axis, converted += curves_at_once) curve(axis, i).store(converted);
}

template <class C, class S, int Dimension>
void convert_group(int degree, const S* given, S* converted) {
  for (std::size_t k = 0; k < curves_at_once; k += GroupLanes<S>::size)
    convert_lanes<C, S, Dimension>(degree, given + k, converted + k);
}

template <class S, class... Es>
inline constexpr typename GroupTable<S>::Evaluators group_evaluators[sizeof...(Es)] = {
    {{evaluate_group<Es, S, 1>, evaluate_group<Es, S, 2>, evaluate_group<Es, S, 3>}}...};

template <class S, class... Cs>
inline constexpr typename GroupTable<S>::Conversions group_conversions[sizeof...(Cs)] = {
    {{convert_group<Cs, S, 1>, convert_group<Cs, S, 2>, convert_group<Cs, S, 3>}}...};

template <class S, class... Es, class... Cs>
constexpr GroupTable<S> group_table_of(TypeList<Es...> /*evaluators*/, TypeList<Cs...> /*conversions*/) {
  return {group_evaluators<S, Es...>, group_conversions<S, Cs...>};
}

}  // namespace bezierbench::batch::HWY_NAMESPACE

namespace bezierbench::batch {

template <class Target, class Scalar>
constinit const GroupTable<Scalar> GroupsOf<Target, Scalar>::table =
    HWY_NAMESPACE::group_table_of<Scalar>(ManyCurves(), ConversionsOfGroups());

}  // namespace bezierbench::batch
