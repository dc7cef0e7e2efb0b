// SPDX-License-Identifier: MIT
// Every method for flattening. One line here makes it exist everywhere.
#pragma once

#include "core/flatten/equal_errors.hpp"
#include "core/flatten/forward_differences.hpp"
#include "core/flatten/hain.hpp"
#include "core/flatten/halving.hpp"
#include "core/flatten/hybrid_differences.hpp"
#include "core/flatten/levien.hpp"
#include "core/flatten/rational_count.hpp"
#include "core/flatten/wang_count.hpp"

namespace bezierbench {

using FlattenMethods = TypeList<WangCount,                   //
                                ForwardDifferences,          //
                                Halving<DistanceCriterion>,  //
                                Halving<AngleCriterion>,     //
                                Halving<AreaCriterion>,      //
                                Halving<LengthCriterion>,    //
                                HybridDifferences,           //
                                Levien,                      //
                                Hain,                        //
                                EqualErrors,                 //
                                RationalCount,               //
                                Halving<DistanceCriterion, Form::rational>, Halving<AngleCriterion, Form::rational>,
                                Halving<AreaCriterion, Form::rational>, Halving<LengthCriterion, Form::rational>>;

}  // namespace bezierbench
