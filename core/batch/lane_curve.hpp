// SPDX-License-Identifier: MIT
// What methods need of lanes besides their arithmetic: a curve that each lane chooses, and values of several numbers in
// memory.
#pragma once

#include <array>

#include "core/batch/lanes.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/triangle.hpp"

namespace bezierbench {

/// The template argument `Degree` of a curve that is, in each lane, one of two, of a degree that is known at run time.
inline constexpr int one_of_two = -3;

template <Form F, class L, int DimensionT>
class Curve<F, L, DimensionT, one_of_two> {
 public:
  using Scalar = L;
  using Either = Curve<F, L, DimensionT>;
  static constexpr Form form = F;
  static constexpr int dimension = DimensionT;
  static constexpr int fixed_degree = dynamic;

  HWY_INLINE Curve(const typename L::Mask& is_first, const Either& first, const Either& second)
      : is_first_(is_first), first_(first), second_(second) {}

  [[nodiscard]] HWY_INLINE int degree() const { return first_.degree(); }
  [[nodiscard]] HWY_INLINE L operator()(int axis, int i) const {
    return select(is_first_, first_(axis, i), second_(axis, i));
  }
  [[nodiscard]] HWY_INLINE L from_end(int axis, int k) const { return (*this)(axis, degree() - k); }

 private:
  const typename L::Mask& is_first_;  // compilers copy it in pieces of a few bytes
  const Either& first_;
  const Either& second_;
};

namespace batch::HWY_NAMESPACE {

template <Form F, class S, int Count, Curves Which, int Dimension, int Degree>
HWY_INLINE Curve<F, Lanes<S, Count, Which>, Dimension, one_of_two> chosen(
    const LaneMask<S, Count>& is_first, const Curve<F, Lanes<S, Count, Which>, Dimension, Degree>& first,
    const Curve<F, Lanes<S, Count, Which>, Dimension, Degree>& second) {
  return {is_first, first, second};
}

}  // namespace batch::HWY_NAMESPACE

namespace detail {

/// They are stored number by number, because compilers copy an aggregate of vectors in pieces of a few bytes.
template <std::size_t Size, class S, int Count, batch::HWY_NAMESPACE::Curves Which>
class ManyNumbers<Size, batch::HWY_NAMESPACE::Lanes<S, Count, Which>> {
  using L = batch::HWY_NAMESPACE::Lanes<S, Count, Which>;

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

  alignas(64) S numbers_[(largest_degree<L> + 1) * Size * L::size];
};

}  // namespace detail
}  // namespace bezierbench
