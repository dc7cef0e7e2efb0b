// SPDX-License-Identifier: MIT
// Properties of a curve that its evaluation in floating point keeps or loses, and the data by which a method says which
// of them it keeps: `guarantees` in its struct, with the proofs in its opening comment.
//
// What the evaluators of the roster say that they keep.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/curve_view.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// What may be proved of an evaluator for Bernstein form or refuted by one input. The exact statements, with what holds
/// for underflow and overflow, stand in experiments/guarantees, each in the header of its name.
enum class Property {
  ends_exact,           ///< p(0) = b_0 and p(1) = b_n
  constant_reproduced,  ///< p(t) = c where all b_i = c
  in_hull,              ///< every coordinate lies between the least and the largest of its control coordinates
  in_convex_hull,       ///< the point lies in the convex hull of the control points
  monotone,             ///< a monotone sequence of control coordinates gives monotone values at increasing t
  reversal,             ///< the reversed points at 1-t give the same values, where 1-t is exact
  translation,          ///< p of b_i + c is p of b_i, plus c, rounded once
  scaling_by_two,       ///< p of 2 b_i is 2 p of b_i
  axes_independent,     ///< a coordinate does not depend on the other axes
  finite,               ///< no infinity and no NaN for t in [0,1]
  total                 ///< a number for t outside [0,1]
};
inline constexpr std::array properties{Property::ends_exact,
                                       Property::constant_reproduced,
                                       Property::in_hull,
                                       Property::in_convex_hull,
                                       Property::monotone,
                                       Property::reversal,
                                       Property::translation,
                                       Property::scaling_by_two,
                                       Property::axes_independent,
                                       Property::finite,
                                       Property::total};

constexpr std::string_view name(Property property) {
  switch (property) {
    case Property::ends_exact: return "ends_exact";
    case Property::constant_reproduced: return "constant_reproduced";
    case Property::in_hull: return "in_hull";
    case Property::in_convex_hull: return "in_convex_hull";
    case Property::monotone: return "monotone";
    case Property::reversal: return "reversal";
    case Property::translation: return "translation";
    case Property::scaling_by_two: return "scaling_by_two";
    case Property::axes_independent: return "axes_independent";
    case Property::finite: return "finite";
    case Property::total: return "total";
  }
  return "";
}

/// A property that is proved of a method, in every scalar type, for the degrees from 1 to `max_degree` that the method
/// supports.
struct Guarantee {
  Property property;
  int max_degree = bezierbench::max_degree;
};

/// What is proved of an evaluator of the roster: its `guarantees`. Empty for a method that states none, for converted
/// paths and for external methods.
std::span<const Guarantee> guarantees_of(const MethodInfo& info);

/// Whether the property is proved of the method at this degree.
bool is_proved(const MethodInfo& info, Property property, int degree);

}  // namespace bezierbench
