// SPDX-License-Identifier: MIT
#pragma once

namespace bezierbench::cli {

/// Whether this processor has the instructions that the program was compiled for (x86-64-v3 with the presets).
bool processor_suffices();

}  // namespace bezierbench::cli
