// SPDX-License-Identifier: MIT
// Methods that read a curve where it lies, without a copy.
#pragma once

#include <type_traits>

#include "core/curve.hpp"

namespace bezierbench {

/// The base of conversions and evaluators whose work per curve is the same arithmetic on every axis, and which accept a
/// view of a curve. A kernel then copies no curve, and converts all axes of a coefficient at once. Without this base a
/// kernel copies the curve and goes axis by axis, with the same bits.
struct SameForEveryAxis {};

template <class Method>
concept IsSameForEveryAxis = std::is_base_of_v<SameForEveryAxis, Method>;

/// The template argument `Degree` of a view of a curve, whose degree is known at run time.
inline constexpr int viewed = -2;

/// Degree of what is computed from a curve and owns its storage: dynamic for a view.
template <int Degree>
inline constexpr int computed_degree = Degree == viewed ? dynamic : Degree;

}  // namespace bezierbench
