// SPDX-License-Identifier: MIT
// A vector that begins on a cache line, as every rival's data does: chance must decide for none of them.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace bezierbench::timing {

inline constexpr std::size_t cache_line = 64;

template <class T>
struct OnCacheLine {
  using value_type = T;

  OnCacheLine() = default;
  template <class U>
  explicit OnCacheLine(const OnCacheLine<U>& /*other*/) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t(cache_line)));
  }
  void deallocate(T* values, std::size_t /*count*/) { ::operator delete(values, std::align_val_t(cache_line)); }

  friend bool operator==(const OnCacheLine& /*a*/, const OnCacheLine& /*b*/) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, OnCacheLine<T>>;

}  // namespace bezierbench::timing
