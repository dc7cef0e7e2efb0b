// SPDX-License-Identifier: MIT
// Every method for arc lengths. One line here makes it exist everywhere.
#pragma once

#include "core/arc_length/adaptive_simpson38.hpp"
#include "core/arc_length/chord_sum.hpp"
#include "core/arc_length/gauss_legendre_24.hpp"
#include "core/arc_length/gauss_legendre_adaptive.hpp"
#include "core/arc_length/rational_length.hpp"
#include "core/arc_length/seed_000_simpson38.hpp"
#include "core/arc_length/simpson38.hpp"

namespace bezierbench {

using ArcLengthMethods = TypeList<AdaptiveSimpson38,                  //
                                  GaussLegendre24,                    //
                                  GaussLegendreAdaptive,              //
                                  ChordSum,                           //
                                  Simpson38,                          //
                                  Seed000Simpson38,                   //
                                  OfRational<AdaptiveSimpson38>,      //
                                  OfRational<GaussLegendre24>,        //
                                  OfRational<GaussLegendreAdaptive>,  //
                                  OfRational<Simpson38>>;

}  // namespace bezierbench
