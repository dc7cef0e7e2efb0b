// SPDX-License-Identifier: MIT
// What it costs to judge methods, against what it costs to run them.
#pragma once

#include "experiments/programs/throughput/comparison.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::throughput {

/// The accuracy study on one thread, inputs drawn and judged against the certified reference, against the bare
/// evaluation of its methods, curve by curve with their scalar kernels, on as many inputs that are there already.
/// `study` has one cell.
Comparison sweep_cost(const suite::Study& study);

}  // namespace bezierbench::throughput
