// SPDX-License-Identifier: MIT
// Exhausted memory in big integers. By default GMP calls abort, without a message for the user.
#pragma once

namespace bezierbench::reference {

/// From now on GMP calls `report`, which must not return, where it cannot allocate memory. An exception would have to
/// pass through functions of C and noexcept ones. To be called before the first big integer is made.
void on_exhausted_memory(void (*report)());

}  // namespace bezierbench::reference
