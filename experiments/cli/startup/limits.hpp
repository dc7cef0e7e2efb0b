// SPDX-License-Identifier: MIT
// Limits that the system sets to a process: what happens where memory or stack ends.
#pragma once

namespace bezierbench::cli {

/// Raises the limit of the stack where it is too low, or throws Failure(Exit::environment) where that is not allowed.
/// To be called first: a stack that overflows ends the program without a word.
void require_stack();

/// From now on the program ends with Exit::environment and one line also where no exception can be caught: in GMP,
/// where one leaves a function that must not throw, and where the stack cannot grow. To be called by the main thread.
void report_exhausted_memory();

/// That line, without anything that would need memory. Does not return.
[[noreturn]] void end_without_memory();

}  // namespace bezierbench::cli
