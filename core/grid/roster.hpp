// SPDX-License-Identifier: MIT
// Every method for points on grids. One line here makes it exist everywhere.
#pragma once

#include "core/evaluate/homogeneous.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"
#include "core/evaluate/methods/horner.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"
#include "core/grid/forward_differencing.hpp"
#include "core/grid/pointwise.hpp"

namespace bezierbench {

using GridMethods = TypeList<Pointwise<DeCasteljau>,        //
                             Pointwise<HornerBernstein>,    //
                             ForwardDifferencingBernstein,  //
                             Pointwise<Horner>,             //
                             ForwardDifferencing,           //
                             Pointwise<Homogeneous<DeCasteljau>>, Pointwise<Homogeneous<HornerBernstein>>>;

}  // namespace bezierbench
