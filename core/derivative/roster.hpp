// SPDX-License-Identifier: MIT
// Every method for derivatives. One line here makes it exist everywhere.
#pragma once

#include "core/derivative/compensated_differences.hpp"
#include "core/derivative/compensated_power_derivative.hpp"
#include "core/derivative/differences_de_casteljau.hpp"
#include "core/derivative/differences_horner.hpp"
#include "core/derivative/power_derivative.hpp"
#include "core/derivative/seed_000.hpp"
#include "core/derivative/triangle_derivatives.hpp"

namespace bezierbench {

using DerivativeMethods = TypeList<DifferencesDeCasteljau,      //
                                   DifferencesHorner,           //
                                   CompensatedDifferences,      //
                                   TriangleDerivatives,         //
                                   PowerDerivative,             //
                                   CompensatedPowerDerivative,  //
                                   Seed000>;

}  // namespace bezierbench
