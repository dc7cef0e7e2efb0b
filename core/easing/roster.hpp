// SPDX-License-Identifier: MIT
// Every method for easing. One line here makes it exist everywhere.
#pragma once

#include "core/easing/cardano.hpp"
#include "core/easing/correctly_rounded.hpp"
#include "core/easing/halley.hpp"
#include "core/easing/itp.hpp"
#include "core/easing/newton_bisection.hpp"
#include "core/easing/table_newton.hpp"

namespace bezierbench {

using EasingMethods = TypeList<EasingCorrectlyRounded,  //
                               EasingHalley,            //
                               EasingItp,               //
                               EasingNewtonBisection,   //
                               EasingTableNewton,       //
                               EasingCardano>;

}  // namespace bezierbench
