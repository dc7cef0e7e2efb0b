// SPDX-License-Identifier: MIT
// The cost of judging methods against the cost of running them.
#pragma once

#include "experiments/programs/throughput/comparison.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::throughput {

/// The accuracy study on one thread, inputs drawn and judged against the certified reference, against the evaluation of
/// its methods alone, curve by curve with their scalar kernels, on as many inputs in memory. `study` has one cell.
Comparison sweep_cost(const suite::Study& study);

}  // namespace bezierbench::throughput
