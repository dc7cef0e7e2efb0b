// SPDX-License-Identifier: MIT
// What big integers do when there is no memory: GMP calls abort, which says nothing to the user.
#pragma once

namespace bezierbench::reference {

/// From now on GMP calls `report`, which must not return, where it gets no memory. An exception would have to pass
/// through functions of C and noexcept ones. To be called before the first big integer is made.
void on_exhausted_memory(void (*report)());

}  // namespace bezierbench::reference
