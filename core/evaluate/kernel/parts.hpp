// SPDX-License-Identifier: MIT
// A prepared state as plain arrays, and the same state for another scalar as views of them: of a state of type
// State<S, D, dynamic> a State<V, D / V::axes, Degree>. A state of several members lists them, in their order, in its
// function `parts`; any other is a curve.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/evaluate/evaluator.hpp"

namespace bezierbench {

/// The arrays of a prepared state, in the order of its parts.
struct Parts {
  int degree;
  std::array<const void*, 4> arrays;
};

namespace detail {

template <class State>
auto members(const State& state) {
  if constexpr (requires { state.parts(); })
    return state.parts();
  else
    return std::tie(state);
}

template <class Member>
int degree_of(const Member& member) {
  if constexpr (requires { member.degree(); })
    return member.degree();
  else
    return 0;
}

/// Whether views of a state can be made, and the number of axes that it has.
template <class State>
inline constexpr bool is_viewed = requires(const State& state) {
  state.parts();
}
|| requires(const State& state) { state.data(); };
template <class State>
inline constexpr int dimension_of = 0;
template <template <Form, class, int, int> class State, Form F, class S, int Dimension, int Degree>
inline constexpr int dimension_of<State<F, S, Dimension, Degree>> = Dimension;
template <template <class, int, int> class State, class S, int Dimension, int Degree>
inline constexpr int dimension_of<State<S, Dimension, Degree>> = Dimension;

template <class Member, class V, int Degree>
struct ViewOf;
template <template <Form, class, int, int> class State, Form F, class S, int Dimension, class V, int Degree>
struct ViewOf<State<F, S, Dimension, dynamic>, V, Degree> {
  using Type = State<F, V, Dimension / V::axes, Degree>;
};
template <template <class, int, int> class State, class S, int Dimension, class V, int Degree>
struct ViewOf<State<S, Dimension, dynamic>, V, Degree> {
  using Type = State<V, Dimension / V::axes, Degree>;
};
template <template <class, int> class Frame, class S, int Dimension, class V, int Degree>
struct ViewOf<Frame<S, Dimension>, V, Degree> {
  using Type = Frame<V, Dimension / V::axes>;
};
template <class S, class V, int Degree>
struct ViewOf<PerCoefficient<S, dynamic>, V, Degree> {
  using Type = Row<V>;
};
template <class Value, std::size_t Dimension, class V, int Degree>
struct ViewOf<std::array<Value, Dimension>, V, Degree> {
  using Type = const Value*;
};

template <class View, class S>
[[gnu::always_inline]] inline View view_of(const void* array, int degree) {
  if constexpr (std::is_pointer_v<View>)
    return static_cast<View>(array);
  else if constexpr (std::is_constructible_v<View, const S*, int>)
    return View(static_cast<const S*>(array), degree);
  else
    return View(static_cast<const S*>(array));
}

template <class View, class V, int Degree, class... Members, std::size_t... K>
[[gnu::always_inline]] inline View state_of(const Parts& parts, const std::tuple<Members...>* /*members*/,
                                            std::index_sequence<K...> /*all*/) {
  return View{view_of<typename ViewOf<std::remove_cvref_t<Members>, V, Degree>::Type, typename V::Scalar>(
      parts.arrays[K], parts.degree)...};
}

}  // namespace detail

template <class State>
Parts parts_of(const State& state) {
  return std::apply(
      [](const auto&... member) {
        return Parts{std::max({detail::degree_of(member)...}), {member.data()...}};
      },
      detail::members(state));
}

/// Returns a view, for the scalar V, of a prepared state that is given by its arrays; `Degree` may be dynamic.
template <class State, class V, int Degree>
[[gnu::always_inline]] inline auto viewed_as(const Parts& parts) {
  using Members = decltype(detail::members(std::declval<const State&>()));
  return detail::state_of<typename detail::ViewOf<State, V, Degree>::Type, V, Degree>(
      parts, static_cast<const Members*>(nullptr), std::make_index_sequence<std::tuple_size_v<Members>>());
}

}  // namespace bezierbench
