// SPDX-License-Identifier: MIT
// SIGINT and SIGTERM. They end a program that only reads at once; a run ends between two blocks.
#pragma once

namespace bezierbench::run {

/// Installs the handlers of SIGINT and SIGTERM. Until work_begins() a signal ends the program, with exit code 130 and
/// one line. After it the first signal is remembered, and the second ends the program.
void watch_for_interruption();

/// Says that results could be lost from here on. The program then checks interrupted() and saves its results before it
/// ends.
void work_begins();

/// True once a signal arrived.
bool interrupted();

}  // namespace bezierbench::run
