// SPDX-License-Identifier: MIT
// What the tests of evaluators share: inputs, curves, points.
#pragma once

#include "experiments/requirements/seeded_curves.hpp"

namespace bezierbench {

using requirements::evaluate;
using requirements::Inputs;
using requirements::view;

}  // namespace bezierbench
