// SPDX-License-Identifier: MIT
#include "experiments/programs/hand_written/family_cells.hpp"

namespace bezierbench::programs {

template void append_cells<double, instantiate::Family::bernstein>(Cells<double>&);
template void append_cells<float, instantiate::Family::bernstein>(Cells<float>&);

}  // namespace bezierbench::programs
