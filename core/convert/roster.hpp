// SPDX-License-Identifier: MIT
// Every conversion. One line here makes it exist everywhere, alone and in front of every evaluator of its target form.
#pragma once

#include "core/convert/differences.hpp"
#include "core/convert/differences_centered.hpp"
#include "core/convert/exact.hpp"
#include "core/convert/factorial.hpp"
#include "core/convert/forward_substitution.hpp"
#include "core/convert/positive_sum.hpp"
#include "core/convert/triangle.hpp"

namespace bezierbench {

using Conversions = TypeList<Factorial,                 //
                             Differences,               //
                             ExactToPower,              //
                             ExactToPowerDoubleDouble,  //
                             DifferencesCentered,       //
                             ExactToPowerCentered,      //
                             ForwardSubstitution,       //
                             PositiveSum,               //
                             Triangle,                  //
                             ExactToBernstein>;

}  // namespace bezierbench
