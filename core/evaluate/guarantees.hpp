// SPDX-License-Identifier: MIT
// What the evaluators of the roster say that they keep.
#pragma once

#include <span>

#include "core/evaluate/guarantee.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// What is proved of an evaluator of the roster: its `guarantees`. Empty for a method that states none, for converted
/// paths and for methods from outside.
std::span<const Guarantee> guarantees_of(const MethodInfo& info);

/// Whether the property is proved of the method at this degree.
bool is_proved(const MethodInfo& info, Property property, int degree);

}  // namespace bezierbench
