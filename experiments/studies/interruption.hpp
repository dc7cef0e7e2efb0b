// SPDX-License-Identifier: MIT
// Ctrl-C and termination: remembered by the signal handler, asked for between blocks.
#pragma once

namespace bezierbench::studies {

/// Installs the handlers of SIGINT and SIGTERM. A second signal ends the program at once.
void watch_for_interruption();

/// True once a signal arrived.
bool interrupted();

}  // namespace bezierbench::studies
