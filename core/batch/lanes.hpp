// SPDX-License-Identifier: MIT
// Many numbers as one scalar. The methods' own headers, instantiated with it, evaluate many points at once: one curve
// at many t, or many curves at one t each. experiments/metric/scale_lanes.cpp computes the scales of many trials.
//
// Each target (AVX2, AVX-512, NEON) includes this file in translation units of its own. The namespace has the name of
// the target, so that no two targets share an inline function.
#pragma once

#include <hwy/highway.h>

#include <bit>

#include "core/batch/target_table.hpp"
#include "core/vector/vectors.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One number for all lanes, for a value that many curves share and that is computed once.
template <class Number>
class Same {
 public:
  HWY_INLINE Same() {}  // NOLINT(modernize-use-equals-default): uninitialised, like a double
  HWY_INLINE explicit Same(double value) : value_(static_cast<Number>(value)) {}
  HWY_INLINE explicit operator double() const { return static_cast<double>(value_); }
  [[nodiscard]] HWY_INLINE Number value() const { return value_; }

  friend HWY_INLINE Same operator*(const Same& a, const Same& b) { return of(a.value_ * b.value_); }
  friend HWY_INLINE Same operator/(const Same& a, const Same& b) { return of(a.value_ / b.value_); }
  friend HWY_INLINE Same operator-(const Same& a) { return of(-a.value_); }

 private:
  static HWY_INLINE Same of(Number value) {
    Same result;
    result.value_ = value;
    return result;
  }

  Number value_;
};

/// The kind of vectors whose lanes are as many points, in `Count` vectors.
template <class Number, int Count>
struct ManyPoints {
  using Scalar = Number;
  using Shared = Same<Number>;
  static constexpr int lanes = HWY_LANES(Number);
  static constexpr int vectors = Count;
  static constexpr int axes = 1;
  static constexpr int numbers = lanes * vectors;
  static constexpr bool shares_t = false;
  static constexpr int largest_degree = max_degree_of_groups;
  using Vector = VectorOf<Number, lanes>;
  using Tag = hn::ScalableTag<Number>;
  // The same in memory: a class of Highway's that holds a Vector or, where the compiler does not optimise, an array.
  using Native = hn::Vec<Tag>;

  /// A coordinate that all lanes share.
  static HWY_INLINE Vector read(const Number* coordinate) { return *coordinate - Vector{}; }
  /// Only where the target has it in hardware.
  static HWY_INLINE Vector fused(const Vector& a, const Vector& b, const Vector& c) {
    static_assert(HWY_NATIVE_FMA != 0 && Count > 0);  // Count: decided only where this is instantiated
    return hn::MulAdd(Native{a}, Native{b}, Native{c}).raw;
  }
  static HWY_INLINE Vector square_root(const Vector& a) {
    return std::bit_cast<Vector>(hn::Sqrt(std::bit_cast<Native>(a)));
  }
  template <class Truths>
  static HWY_INLINE bool all(const Truths& truths) {
    if constexpr (lanes == 1)
      return truths;
    else
      return hn::AllTrue(Tag(), hn::MaskFromVec(std::bit_cast<Native>(truths)));
  }
  template <class Truths>
  static HWY_INLINE bool any(const Truths& truths) {
    if constexpr (lanes == 1)
      return truths;
    else
      return !hn::AllFalse(Tag(), hn::MaskFromVec(std::bit_cast<Native>(truths)));
  }
};

/// Lanes that are parameters of one curve, which is a view, or of one curve each, which are values.
template <class Number, int Count, Held held = Held::by_reference>
using Lanes = Vectors<ManyPoints<Number, Count>, held>;

/// `value` in the lanes where `condition` holds, `otherwise(lane)` in the others, which are rare.
template <class Number, int Count, Held held, class Otherwise>
HWY_INLINE Lanes<Number, Count, held> value_or(const typename Lanes<Number, Count, held>::Mask& condition,
                                               const Lanes<Number, Count, held>& value, const Otherwise& otherwise) {
  using L = Lanes<Number, Count, held>;
  if (all_of(condition)) return value;
  Number holds[L::size];
  select(condition, L(Number(1)), L(Number(0))).store(holds);
  Number values[L::size];
  value.store(values);
  for (std::size_t lane = 0; lane < L::size; ++lane)
    if (holds[lane] == 0) values[lane] = otherwise(lane);
  return L::load(values);
}

/// The lanes of `result` that are numbers. A lane that is NaN becomes `settle(t)` with the t of that lane, one after
/// the other, so that few should be.
template <class Number, int Count, Held held, class Settle>
HWY_INLINE Lanes<Number, Count, held> or_else(const Lanes<Number, Count, held>& result,
                                              const Lanes<Number, Count, held>& t, const Settle& settle) {
  return value_or(result <= result, result, [&](std::size_t lane) { return settle(lane_of(t, lane)); });
}

}  // namespace bezierbench::batch::HWY_NAMESPACE
