// SPDX-License-Identifier: MIT
#include "reference/exhausted_memory.hpp"

#include <gmp.h>

#include <cstddef>
#include <cstdlib>

namespace bezierbench::reference {
namespace {

void (*report_exhausted)() = std::abort;

void* given(void* memory) {
  if (memory == nullptr) report_exhausted();
  return memory;
}

void* allocate(std::size_t size) { return given(std::malloc(size)); }
void* reallocate(void* memory, std::size_t /*old_size*/, std::size_t size) { return given(std::realloc(memory, size)); }

}  // namespace

void on_exhausted_memory(void (*report)()) {
  report_exhausted = report;
  mp_set_memory_functions(allocate, reallocate, nullptr);  // null: freed as ever
}

}  // namespace bezierbench::reference
