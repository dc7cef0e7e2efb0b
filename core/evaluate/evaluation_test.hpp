// SPDX-License-Identifier: MIT
// What the tests of evaluators share: inputs, curves, points.
#pragma once

#include "experiments/properties/seeded_curves.hpp"

namespace bezierbench {

using properties::evaluate;
using properties::Inputs;
using properties::view;

}  // namespace bezierbench
