// SPDX-License-Identifier: MIT
// A vector that begins at a given offset within a page of 4096 bytes, so that corresponding data of all rivals have the
// same offset.
//
// A processor first compares the addresses of a load and of pending stores by their offsets within a page. A load after
// a store at the same offset of another page may wait for it needlessly, so the allocator could make one of two equal
// kernels faster. Sources: AMD, Software Optimization Guide 25112, section 5.5, on false dependencies; Intel, IA-32
// Optimization Reference Manual, section 2, on aliasing by multiples of 4 kilobytes.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace bezierbench::race {

inline constexpr std::size_t page = 4096;

template <class T, std::size_t Place>
struct AtPagePlace {
  static_assert(Place < page && Place % alignof(T) == 0);
  using value_type = T;
  template <class U>
  struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
    using other = AtPagePlace<U, Place>;
  };

  AtPagePlace() = default;
  template <class U>
  explicit AtPagePlace(const AtPagePlace<U, Place>& /*other*/) {}

  T* allocate(std::size_t count) {
    auto* pages = static_cast<std::byte*>(::operator new(Place + count * sizeof(T), std::align_val_t(page)));
    return reinterpret_cast<T*>(pages + Place);
  }
  void deallocate(T* values, std::size_t /*count*/) {
    ::operator delete(reinterpret_cast<std::byte*>(values) - Place, std::align_val_t(page));
  }

  friend bool operator==(const AtPagePlace& /*a*/, const AtPagePlace& /*b*/) { return true; }
};

/// Begins `Place` bytes into a page.
template <class T, std::size_t Place>
using PageVector = std::vector<T, AtPagePlace<T, Place>>;

}  // namespace bezierbench::race
