// SPDX-License-Identifier: MIT
// What the runtime libraries of Debian for wasm32 leave out. C++ exceptions are those of WebAssembly, for libc++abi is built
// without any: no handler of the library asks for a type, so an exception has its object and what destroys it, and no tables;
// guarded() asks what was thrown. The compiler's functions for integers of 128 bits guard their stack. Both functions for fused
// multiply-adds are wrong for a few arguments; bindings/web/web_test.py found them.
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

#include "bindings/c/status.hpp"
#include "core/error_free.hpp"
#include "reference/length/true_length.hpp"

namespace {

/// What lies before the object that was thrown.
struct alignas(std::max_align_t) Thrown {
  const std::type_info* type;
  void (*destroy)(void*);
};

void* caught = nullptr;  // no handler of the library throws

Thrown& thrown_with(void* object) { return static_cast<Thrown*>(object)[-1]; }

}  // namespace

extern "C" {

void* __cxa_allocate_exception(std::size_t size) noexcept {
  auto* thrown = static_cast<Thrown*>(std::malloc(sizeof(Thrown) + size));
  if (thrown == nullptr) std::abort();
  return thrown + 1;
}

void __cxa_free_exception(void* object) noexcept { std::free(&thrown_with(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void (*destroy)(void*)) {
  thrown_with(object) = {type, destroy};
  __builtin_wasm_throw(0, object);
}

void* __cxa_begin_catch(void* object) noexcept { return caught = object; }

void __cxa_end_catch() {
  auto& thrown = thrown_with(caught);
  if (thrown.destroy != nullptr) thrown.destroy(caught);
  std::free(&thrown);
}

/// Debian's adds c where it is 0 to a rounded a b: a product that underflows loses the sign of its 0. The linker calls this one.
double __real_fma(double a, double b, double c);
double __wrap_fma(double a, double b, double c) { return c == 0 && a != 0 && b != 0 ? a * b : __real_fma(a, b, c); }

/// Debian's rounds twice where the sum in double is halfway between two floats. Rounded to odd instead, with
/// its 53 bits the sum decides as the exact one does ([Boldo and Melquiond 2008]).
float fmaf(float a, float b, float c) {
  const double product = static_cast<double>(a) * b;  // exact
  const auto sum = bezierbench::two_sum<double>(product, c);
  const auto bits = std::bit_cast<std::int64_t>(sum.value);
  if (!(std::abs(sum.error) > 0) || bits % 2 != 0) return static_cast<float>(sum.value);
  return static_cast<float>(std::bit_cast<double>(bits + ((sum.error > 0) == (sum.value > 0) ? 1 : -1)));
}

std::uintptr_t __stack_chk_guard = 0x4c95a317;
[[noreturn]] void __stack_chk_fail() { std::abort(); }

}  // extern "C"

/// libc++abi's own would end the program.
void* operator new(std::size_t size) {
  if (void* place = std::malloc(size > 0 ? size : 1)) return place;
  throw std::bad_alloc();
}

namespace bezierbench::c {

bb_status status_of_exception() noexcept {
  const std::type_info& type = *thrown_with(caught).type;
  if (type == typeid(Refused)) return static_cast<const Refused*>(caught)->status;
  if (type == typeid(std::bad_alloc)) return BB_ERROR_MEMORY;
  if (type == typeid(reference::Stopped)) return BB_ERROR_STOPPED;
  if (type == typeid(reference::NotCertain)) return BB_ERROR_NOT_CERTAIN;
  return BB_ERROR_INTERNAL;
}

}  // namespace bezierbench::c
