// SPDX-License-Identifier: MIT
// Every method for inverse arc length. One line here makes it exist everywhere.
#pragma once

#include "core/arc_length/inverse/bracketed_newton.hpp"
#include "core/arc_length/inverse/chord_equalising.hpp"
#include "core/arc_length/inverse/halley.hpp"
#include "core/arc_length/inverse/seed_000_newton.hpp"
#include "core/arc_length/rational_length.hpp"

namespace bezierbench {

using InverseArcLengthMethods = TypeList<BracketedNewton,              //
                                         Halley,                       //
                                         Seed000Newton,                //
                                         ChordEqualising,              //
                                         OfRational<BracketedNewton>,  //
                                         OfRational<Halley>>;

}  // namespace bezierbench
