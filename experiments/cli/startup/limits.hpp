// SPDX-License-Identifier: MIT
// Limits that the system sets to a process: what happens where memory or stack ends.
#pragma once

#include <string_view>

namespace bezierbench::cli {

/// Raises the limit of the stack where it is too low, or throws Failure(Exit::environment) where that is not allowed.
/// To be called first: a stack that overflows ends the program without a word.
void require_stack();

/// From now on the program ends with Exit::environment and one line also where no exception can be caught: in GMP,
/// where one leaves a function that must not throw, and where the stack cannot grow. To be called by the main thread.
void report_exhausted_memory();

/// That line, without anything that would need memory. Does not return.
[[noreturn]] void end_without_memory();

/// The same for a library that cannot go on, in its words: oneTBB where it cannot start a thread.
[[noreturn]] void end_without_resource(std::string_view reason);

}  // namespace bezierbench::cli
