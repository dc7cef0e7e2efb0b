// SPDX-License-Identifier: MIT
// Every method for piecewise fitting. One line here makes it exist everywhere.
#pragma once

#include "core/fit/gauss_newton.hpp"
#include "core/fit/schneider.hpp"

namespace bezierbench {

using FittingMethods = TypeList<Schneider,  //
                                GaussNewton>;

}  // namespace bezierbench
