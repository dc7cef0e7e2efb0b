// SPDX-License-Identifier: MIT
// Ctrl-C and termination: they end a program that is only reading; one at work is asked between blocks.
#pragma once

namespace bezierbench::run {

/// Installs the handlers of SIGINT and SIGTERM. Until work_begins() a signal ends the program, with exit code 130 and a
/// line that says so; from then on the first is remembered and the second ends the program.
void watch_for_interruption();

/// From here on something would be lost with the program: it looks at interrupted() and keeps what is done.
void work_begins();

/// True once a signal arrived.
bool interrupted();

}  // namespace bezierbench::run
