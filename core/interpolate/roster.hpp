// SPDX-License-Identifier: MIT
// Every method for interpolation. One line here makes it exist everywhere.
#pragma once

#include "core/interpolate/c2_natural.hpp"
#include "core/interpolate/c2_natural_handles.hpp"
#include "core/interpolate/seed_003.hpp"

namespace bezierbench {

using InterpolationMethods = TypeList<C2Natural,         //
                                      C2NaturalHandles,  //
                                      Seed003>;

}  // namespace bezierbench
