// SPDX-License-Identifier: MIT
#include "experiments/programs/hand_written/family_cells.hpp"

namespace bezierbench::programs {

template void append_cells<double, instantiate::Family::triangle>(Cells<double>&);
template void append_cells<float, instantiate::Family::triangle>(Cells<float>&);

}  // namespace bezierbench::programs
