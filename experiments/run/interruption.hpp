// SPDX-License-Identifier: MIT
// SIGINT and SIGTERM end the program with exit code 130 and one line: at once where it only reads, and within a second
// where results could be lost.
#pragma once

#include <string_view>

namespace bezierbench::run {

/// Installs the handlers of SIGINT and SIGTERM. Until work_begins() a signal ends the program.
void watch_for_interruption();

/// Says that results could be lost from here on. The program then checks interrupted() between two pieces of work, and
/// saves its results before it ends. Where a piece takes longer than most of a second, the program is ended with
/// `line`; what was saved before is kept. A second signal ends it without a word.
void work_begins(std::string_view line);

/// Stops the timer that a signal started. To be called when the results are saved and the caller itself writes the line
/// and ends the program, however long that takes.
void ends_by_itself();

/// True once a signal arrived.
bool interrupted();

}  // namespace bezierbench::run
