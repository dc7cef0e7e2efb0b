// SPDX-License-Identifier: MIT
// Every method for subdivision. One line here makes it exist everywhere.
#pragma once

#include "core/subdivide/blossom_split.hpp"
#include "core/subdivide/de_casteljau_split.hpp"
#include "core/subdivide/homogeneous_split.hpp"
#include "core/subdivide/lerp_split.hpp"
#include "core/subdivide/matrix_split.hpp"
#include "core/subdivide/two_sided_split.hpp"

namespace bezierbench {

using SplitMethods = TypeList<DeCasteljauSplit,                    //
                              LerpSplit,                           //
                              TwoSidedSplit,                       //
                              BlossomSplit,                        //
                              MatrixSplit,                         //
                              HomogeneousSplit<DeCasteljauSplit>,  //
                              HomogeneousSplit<LerpSplit>,         //
                              HomogeneousSplit<TwoSidedSplit>,     //
                              HomogeneousSplit<BlossomSplit>,      //
                              HomogeneousSplit<MatrixSplit>>;

}  // namespace bezierbench
