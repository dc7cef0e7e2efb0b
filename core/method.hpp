// SPDX-License-Identifier: MIT
// The data that every method states next to its code; docs, tests and the run-time check read this one value.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/bound/error_bound.hpp"
#include "core/curve_view.hpp"

namespace bezierbench {

/// The problem that a method solves.
enum class Problem {
  evaluation,
  conversion,
  derivative,
  arc_length,
  inverse_arc_length,
  projection,
  interpolation,
  fitting,
  subdivision,
  grid,
  bspline,
  flattening,
  bounds,
  easing,
  roots
};

constexpr std::string_view name(Problem problem) {
  switch (problem) {
    case Problem::evaluation: return "evaluation";
    case Problem::conversion: return "conversion";
    case Problem::derivative: return "derivative";
    case Problem::arc_length: return "arc_length";
    case Problem::inverse_arc_length: return "inverse_arc_length";
    case Problem::projection: return "projection";
    case Problem::interpolation: return "interpolation";
    case Problem::fitting: return "fitting";
    case Problem::subdivision: return "subdivision";
    case Problem::grid: return "grid";
    case Problem::bspline: return "bspline";
    case Problem::flattening: return "flattening";
    case Problem::bounds: return "bounds";
    case Problem::easing: return "easing";
    case Problem::roots: return "roots";
  }
  return "";
}

/// Which curve a method evaluates if s, the rounded 1 - t, is the only rounding. For a rational curve the last two are
/// the same, since numerator and denominator both have the factor (t + s)^n.
enum class OneMinusT {
  unused,     ///< s is not used, or only where it is exact, or its error is compensated
  summed,     ///< sum b_i C(n,i) t^i s^(n-i)
  normalised  ///< this sum over (t + s)^n: only the ratio of t and s is used
};

/// The part of a method that is data.
struct MethodInfo {
  std::string_view id;     ///< permanent key in files, command lines and reports
  std::string_view label;  ///< for people
  Problem problem = Problem::evaluation;
  Form form = Form::bernstein;  ///< form of the curve that the method takes
  int min_degree = 0;
  int max_degree = bezierbench::max_degree;        ///< in double
  int max_degree_float = bezierbench::max_degree;  ///< in float, whose range is smaller
  bool unit_interval_only = false;                 ///< t outside [0,1] is outside its domain
  std::optional<ErrorBound> bound = std::nullopt;
  std::string_view promise = {};  ///< of a companion problem's method: the property that its results have, for people
  bool bit_stable = true;         ///< false where libm decides the last bits
  bool fused = false;             ///< has fused multiply-adds: slow where std::fma is a call
  OneMinusT one_minus_t = OneMinusT::unused;
  std::string_view flops;     ///< in n and d, per point, a fused multiply-add being one; for a conversion, per curve
  int cost_exponent = 1;      ///< k of the claim that these flops are O(n^k)
  int prepare_exponent = 1;   ///< k of the claim that `prepare` costs O(n^k); not for conversions
  std::string_view citation;  ///< keys of reference/published/SOURCES.md in brackets, each with its section or equation

  /// True for the degrees that the method promises in this scalar type.
  template <class Scalar>
  [[nodiscard]] constexpr bool supports(int degree) const {
    return degree >= min_degree && degree <= (sizeof(Scalar) == sizeof(float) ? max_degree_float : max_degree);
  }
};

/// A list of types, the only way in which methods are registered.
template <class... Ts>
struct TypeList {
  static constexpr std::size_t size = sizeof...(Ts);
};

/// Several lists as one.
template <class... Lists>
struct Concatenated {
  using Type = TypeList<>;
};
template <class... Ts>
struct Concatenated<TypeList<Ts...>> {
  using Type = TypeList<Ts...>;
};
template <class... Ts, class... Us, class... Rest>
struct Concatenated<TypeList<Ts...>, TypeList<Us...>, Rest...> {
  using Type = typename Concatenated<TypeList<Ts..., Us...>, Rest...>::Type;
};

/// The data of the methods of a roster, in its order.
template <class... Methods>
std::span<const MethodInfo* const> infos_of(TypeList<Methods...> /*roster*/) {
  static constexpr std::array<const MethodInfo*, sizeof...(Methods)> infos{&Methods::info...};
  return infos;
}

}  // namespace bezierbench
