// SPDX-License-Identifier: MIT
// Every method for B-spline curves. One line here makes it exist everywhere.
#pragma once

#include "core/bspline/chudy_wozny_span.hpp"
#include "core/bspline/de_boor.hpp"
#include "core/bspline/de_boor_cox_basis.hpp"
#include "core/bspline/knot_insertion_span.hpp"

namespace bezierbench {

using BsplineMethods = TypeList<DeBoor,             //
                                DeBoorCoxBasis,     //
                                KnotInsertionSpan,  //
                                ChudyWoznySpan>;

}  // namespace bezierbench
