// SPDX-License-Identifier: MIT
// Runs code with an offset of its stack. Local arrays that straddle cache lines, or share sets of a cache with the
// data, cost time that is not the method's, so several offsets are tried.
#pragma once

#include <cstddef>
#include <utility>

namespace bezierbench::race {

/// Calls `body()` with the stack 528 * step bytes further down: each step has another 16-byte offset within a cache
/// line and another eighth of a page. step < 1024.
template <class Body>
[[gnu::noinline]] auto with_stack_moved(std::size_t step, Body&& body) {
  constexpr std::size_t bytes_per_step = 528;
  auto* room = static_cast<volatile char*>(__builtin_alloca(bytes_per_step * step + 1));
  *room = 0;  // keeps the compiler from removing the allocation
  return std::forward<Body>(body)();
}

}  // namespace bezierbench::race
