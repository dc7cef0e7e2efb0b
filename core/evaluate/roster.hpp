// SPDX-License-Identifier: MIT
// Every evaluator. One line here makes it exist everywhere: accuracy, timing, tests, `list`, the report, the README.
#pragma once

#include "core/evaluate/de_casteljau.hpp"
#include "core/evaluate/de_casteljau_lerp.hpp"
#include "core/evaluate/direct.hpp"
#include "core/evaluate/direct_pow.hpp"
#include "core/evaluate/horner.hpp"
#include "core/evaluate/horner_bernstein.hpp"
#include "core/evaluate/power_sum.hpp"

namespace bezierbench {

using Evaluators = TypeList<Direct,           //
                            DirectPow,        //
                            DeCasteljau,      //
                            DeCasteljauLerp,  //
                            HornerBernstein,  //
                            PowerSum,         //
                            Horner>;

}  // namespace bezierbench
