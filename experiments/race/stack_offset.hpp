// SPDX-License-Identifier: MIT
// Runs code with its stack elsewhere: local arrays that straddle cache lines, or share sets of a cache with the data,
// cost time that says nothing of the method, so that several places must be tried.
#pragma once

#include <cstddef>
#include <utility>

namespace bezierbench::race {

/// Calls `body()` with the stack 528 * step bytes further down: another 16-byte place within a cache line, and another
/// eighth of a page. step < 1024.
template <class Body>
[[gnu::noinline]] auto with_stack_moved(std::size_t step, Body&& body) {
  constexpr std::size_t bytes_per_step = 528;
  auto* room = static_cast<volatile char*>(__builtin_alloca(bytes_per_step * step + 1));
  *room = 0;  // or else the compiler may do without the room
  return std::forward<Body>(body)();
}

}  // namespace bezierbench::race
