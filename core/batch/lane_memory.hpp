// SPDX-License-Identifier: MIT
// Lanes between two steps of a method that has more of them than registers.
#pragma once

#include <array>

#include "core/batch/lanes.hpp"
#include "core/curve_view.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

/// Room for one value of `Size` numbers per coefficient. They are stored number by number, because compilers copy an
/// aggregate of vectors in pieces of a few bytes.
template <std::size_t Size, class L>
class ManyNumbers {
 public:
  HWY_INLINE std::array<L, Size> operator[](int i) const {
    std::array<L, Size> value;
    for (std::size_t k = 0; k < Size; ++k) value[k] = L::load(numbers_ + place(i, k));
    return value;
  }
  HWY_INLINE void set(int i, const std::array<L, Size>& value) {
    for (std::size_t k = 0; k < Size; ++k) value[k].store(numbers_ + place(i, k));
  }

 private:
  static HWY_INLINE std::size_t place(int i, std::size_t k) {
    return (static_cast<std::size_t>(i) * Size + k) * L::size;
  }

  alignas(64) typename L::Scalar numbers_[(max_degree + 1) * Size * L::size];
};

}  // namespace bezierbench::batch::HWY_NAMESPACE
