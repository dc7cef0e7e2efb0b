// SPDX-License-Identifier: MIT
// What the program does when memory or stack is exhausted.
#pragma once

#include <string_view>

namespace bezierbench::cli {

/// Raises the limit of the stack where it is too low. Throws Failure(Exit::environment) where that is not allowed. Call
/// this first: a stack overflow ends the program without a message.
void require_stack();

/// Throws Failure(Exit::environment) where the limit of virtual memory is too low. Call this before oneTBB is used:
/// oneTBB 2022.1 waits forever where its first allocation fails.
void require_memory();

/// Makes the program end with Exit::environment and one line also where no exception can be caught: in GMP, where an
/// exception leaves a function that must not throw, and where the stack cannot grow. Call this from the main thread.
void report_exhausted_memory();

/// Writes the line about exhausted memory without allocating, and ends the program.
[[noreturn]] void end_without_memory();

/// Ends the program in the same way with `reason`, the message of a library that cannot continue: oneTBB, when it
/// cannot start a thread.
[[noreturn]] void end_without_resource(std::string_view reason);

}  // namespace bezierbench::cli
