// SPDX-License-Identifier: MIT
// `Kernel::evaluate_for` of an evaluator. Its functions evaluate one point after the other, with the axes of a point in
// one vector, and with the degree known at compile time where that is faster. Each gives the same bits as the
// method evaluated with plain numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/evaluate/kernel/parts.hpp"
#include "core/evaluate/kernel/points/along_curve.hpp"
#include "core/evaluate/kernel/points/axes.hpp"

namespace bezierbench::instantiate {

/// An evaluator whose prepared state can be read with all axes of a coefficient at once.
template <class E, class S, int Dimension>
concept SideBySide = detail::is_viewed<PreparedOf<E, S, Dimension>> && !requires {
  PreparedOf<E, S, Dimension>::by_axis;
};

// CMakePresets.json lowers it for sanitizers, under which a unit would compile for minutes.
#ifndef BEZIERBENCH_LARGEST_FIXED_DEGREE
#define BEZIERBENCH_LARGEST_FIXED_DEGREE max_degree
#endif

/// The largest degree with a kernel of its own: what the method says (-1: none), else 12. Beyond, the code for every
/// degree takes little longer.
template <class E>
constexpr int largest_fixed_degree() {
  int largest = 12;
  if constexpr (requires { E::largest_fixed_degree; }) largest = E::largest_fixed_degree;
  return std::min(largest, BEZIERBENCH_LARGEST_FIXED_DEGREE);
}

// A sanitizer adds checks to each copy of an inlined function: with all calls inlined, a unit takes minutes to compile.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BEZIERBENCH_INLINE_ALL_CALLS
#else
#define BEZIERBENCH_INLINE_ALL_CALLS [[gnu::flatten]]
#endif

/// All axes side by side, the degree fixed or dynamic.
template <class E, class S, int Dimension, int Degree>
BEZIERBENCH_INLINE_ALL_CALLS void evaluate_side_by_side(const void* prepared, std::span<const S> t, S* points) {
  using State = PreparedOf<E, S, Dimension>;
  using A = Axes<S, detail::dimension_of<State>>;
  auto view = viewed_as<State, A, Degree>(parts_of(*static_cast<const State*>(prepared)));
  with_evaluation<E>(view, [&view, t, points](const auto& point_at) {
    S* next = points;
    for (const S at : t) {
      // As if the view changed: else GCC computes the addresses of all coefficients before the loop, for every call.
      if constexpr (Degree == dynamic) asm volatile("" : "+m"(view));
      point_at(A(at))[0].template store<Dimension>(next);
      next += Dimension;
    }
  });
}

template <class E, class S, int Dimension, int... Degree>
constexpr auto fixed_degrees(std::integer_sequence<int, Degree...> /*degrees*/) {
  return std::array{EvaluatePoints<S>(evaluate_side_by_side<E, S, Dimension, Degree>)...};
}

/// The function for prepared curves of this degree.
template <class E, class S, int Dimension>
EvaluatePoints<S> evaluate_for([[maybe_unused]] int degree) {
  if constexpr (SideBySide<E, S, Dimension>) {
    constexpr int largest = largest_fixed_degree<E>();
    if constexpr (largest >= 0) {
      static constexpr auto fixed = fixed_degrees<E, S, Dimension>(std::make_integer_sequence<int, largest + 1>());
      if (degree <= largest) return fixed[static_cast<std::size_t>(degree)];
    }
    return evaluate_side_by_side<E, S, Dimension, dynamic>;
  } else {
    return evaluate_one_by_one<E, S, Dimension>;
  }
}

}  // namespace bezierbench::instantiate
