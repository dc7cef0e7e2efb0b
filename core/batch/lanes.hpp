// SPDX-License-Identifier: MIT
// Many parameters t as one scalar: the methods' own headers, instantiated with it, evaluate at all of them at once.
//
// Every lane is computed with the same IEEE operations in the same order as the scalar method's, so with the same bits
// (of what is no number, only that it is none). Included by one translation unit per target, compiled for that target;
// the namespace bears the target's name, so that no two targets share an inline function.
#pragma once

#include <hwy/highway.h>

#include <cstddef>

namespace bezierbench::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One choice per lane.
template <class Scalar, int Count>
struct LaneMask {
  hn::Mask<hn::ScalableTag<Scalar>> mask[Count];
};

/// `Count` vectors of scalars, for steps that do not wait for each other.
template <class ScalarT, int Count>
class Lanes {
 public:
  using Scalar = ScalarT;
  using Tag = hn::ScalableTag<Scalar>;
  using Vector = hn::Vec<Tag>;
  using Mask = LaneMask<Scalar, Count>;
  static constexpr std::size_t per_vector = HWY_LANES(Scalar);
  static constexpr std::size_t size = per_vector * Count;

  HWY_INLINE Lanes() {}  // NOLINT(modernize-use-equals-default): leaves them uninitialised, as of a double
  /// The same value in all lanes.
  HWY_INLINE explicit Lanes(Scalar value) {
    for (int k = 0; k < Count; ++k) vector_[k] = hn::Set(Tag(), value);
  }
  /// Reads `size` values.
  static HWY_INLINE Lanes load(const Scalar* values) {
    return each([&](int k) { return hn::LoadU(Tag(), values + static_cast<std::size_t>(k) * per_vector); });
  }
  HWY_INLINE void store(Scalar* values) const {
    for (int k = 0; k < Count; ++k) hn::StoreU(vector_[k], Tag(), values + static_cast<std::size_t>(k) * per_vector);
  }

  friend HWY_INLINE Lanes operator+(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return hn::Add(a.vector_[k], b.vector_[k]); });
  }
  friend HWY_INLINE Lanes operator-(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return hn::Sub(a.vector_[k], b.vector_[k]); });
  }
  friend HWY_INLINE Lanes operator*(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return hn::Mul(a.vector_[k], b.vector_[k]); });
  }
  friend HWY_INLINE Lanes operator/(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return hn::Div(a.vector_[k], b.vector_[k]); });
  }
  friend HWY_INLINE Lanes operator-(const Lanes& a) {
    return each([&](int k) { return hn::Xor(a.vector_[k], hn::Set(Tag(), -Scalar(0))); });
  }
  HWY_INLINE Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  HWY_INLINE Lanes& operator*=(const Lanes& b) { return *this = *this * b; }

  /// *this b + c with one rounding; only where the target has it in hardware.
  [[nodiscard]] HWY_INLINE Lanes fused(const Lanes& b, const Lanes& c) const {
    static_assert(HWY_NATIVE_FMA != 0);
    return each([&](int k) { return hn::MulAdd(vector_[k], b.vector_[k], c.vector_[k]); });
  }

  friend HWY_INLINE Mask operator<=(const Lanes& a, const Lanes& b) {
    Mask result;
    for (int k = 0; k < Count; ++k) result.mask[k] = hn::Le(a.vector_[k], b.vector_[k]);
    return result;
  }
  friend HWY_INLINE Lanes select(const Mask& condition, const Lanes& first, const Lanes& second) {
    return each([&](int k) { return hn::IfThenElse(condition.mask[k], first.vector_[k], second.vector_[k]); });
  }

 private:
  template <class Of>
  static HWY_INLINE Lanes each(Of of) {
    Lanes result;
    for (int k = 0; k < Count; ++k) result.vector_[k] = of(k);
    return result;
  }

  Vector vector_[Count];
};

}  // namespace bezierbench::batch::HWY_NAMESPACE
