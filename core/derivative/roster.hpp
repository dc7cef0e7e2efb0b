// SPDX-License-Identifier: MIT
// Every method for derivatives. One line here makes it exist everywhere.
#pragma once

#include "core/derivative/all_orders.hpp"
#include "core/derivative/compensated_differences.hpp"
#include "core/derivative/compensated_power_derivative.hpp"
#include "core/derivative/differences_de_casteljau.hpp"
#include "core/derivative/differences_horner.hpp"
#include "core/derivative/power_derivative.hpp"
#include "core/derivative/rational_quotient.hpp"
#include "core/derivative/seed_000.hpp"
#include "core/derivative/triangle_derivatives.hpp"
#include "core/derivative/wozny_chudy_derivatives.hpp"

namespace bezierbench {

using DerivativeMethods = TypeList<DifferencesDeCasteljau,                          //
                                   DifferencesHorner,                               //
                                   CompensatedDifferences,                          //
                                   TriangleDerivatives,                             //
                                   WoznyChudyDerivatives,                           //
                                   AllOrders<DifferencesHorner>,                    //
                                   AllOrders<TriangleDerivatives>,                  //
                                   AllOrders<WoznyChudyDerivatives>,                //
                                   RationalQuotient<DifferencesHorner, false>,      //
                                   RationalQuotient<TriangleDerivatives, false>,    //
                                   RationalQuotient<WoznyChudyDerivatives, false>,  //
                                   RationalQuotient<DifferencesHorner, true>,       //
                                   RationalQuotient<TriangleDerivatives, true>,     //
                                   PowerDerivative,                                 //
                                   CompensatedPowerDerivative,                      //
                                   Seed000>;

}  // namespace bezierbench
