// SPDX-License-Identifier: MIT
// Limits of the system on a process: what the program does when memory or stack is exhausted.
#pragma once

#include <string_view>

namespace bezierbench::cli {

/// Raises the limit of the stack where it is too low, or throws Failure(Exit::environment) where that is not allowed.
/// To be called first, because a stack overflow ends the program without a message.
void require_stack();

/// From now on the program ends with Exit::environment and one line also where no exception can be caught: in GMP,
/// where one leaves a function that must not throw, and where the stack cannot grow. To be called by the main thread.
void report_exhausted_memory();

/// Writes that line without allocating memory, and ends the program. Does not return.
[[noreturn]] void end_without_memory();

/// The same for a library that cannot go on, in its words: oneTBB where it cannot start a thread.
[[noreturn]] void end_without_resource(std::string_view reason);

}  // namespace bezierbench::cli
