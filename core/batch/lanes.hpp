// SPDX-License-Identifier: MIT
// Many numbers as one scalar. Instantiated with it, the methods' own headers evaluate at many parameters t at once, on
// one curve or on a curve for each; experiments/metric/scale_lanes.cpp computes the scales of many trials.
//
// Every lane performs the IEEE operations of the scalar method in the same order, and has the same bits. The payload of
// a NaN may differ. Each target includes this in translation units compiled for it; the namespace has the target's
// name, so that no two targets share an inline function.
#pragma once

#include <hwy/highway.h>

#include <concepts>
#include <cstddef>
#include <utility>

#include "core/batch/target_table.hpp"
#include "core/curve_view.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A truth value per lane.
template <class Scalar, int Count>
struct LaneMask {
  hn::Mask<hn::ScalableTag<Scalar>> mask[Count];

  friend HWY_INLINE LaneMask both(const LaneMask& a, const LaneMask& b) {
    LaneMask result;
    for (int k = 0; k < Count; ++k) result.mask[k] = hn::And(a.mask[k], b.mask[k]);
    return result;
  }
  friend HWY_INLINE bool all_of(const LaneMask& a) {
    auto all = a.mask[0];
    for (int k = 1; k < Count; ++k) all = hn::And(all, a.mask[k]);
    return hn::AllTrue(hn::ScalableTag<Scalar>(), all);
  }
  friend HWY_INLINE LaneMask either(const LaneMask& a, const LaneMask& b) {
    LaneMask result;
    for (int k = 0; k < Count; ++k) result.mask[k] = hn::Or(a.mask[k], b.mask[k]);
    return result;
  }
  friend HWY_INLINE bool any_of(const LaneMask& a) {
    auto any = a.mask[0];
    for (int k = 1; k < Count; ++k) any = hn::Or(any, a.mask[k]);
    return !hn::AllFalse(hn::ScalableTag<Scalar>(), any);
  }
};

/// One number for all lanes, for a value that many curves share and that is computed once.
template <class Scalar>
class Same {
 public:
  HWY_INLINE Same() {}  // NOLINT(modernize-use-equals-default): uninitialised, like a double
  HWY_INLINE explicit Same(double value) : value_(static_cast<Scalar>(value)) {}
  HWY_INLINE explicit operator double() const { return static_cast<double>(value_); }
  [[nodiscard]] HWY_INLINE Scalar value() const { return value_; }

  friend HWY_INLINE Same operator*(const Same& a, const Same& b) { return of(a.value_ * b.value_); }
  friend HWY_INLINE Same operator/(const Same& a, const Same& b) { return of(a.value_ / b.value_); }
  friend HWY_INLINE Same operator-(const Same& a) { return of(-a.value_); }

 private:
  static HWY_INLINE Same of(Scalar value) {
    Same result;
    result.value_ = value;
    return result;
  }

  Scalar value_;
};

/// Whether the lanes are parameters of one curve or of one curve each.
enum class Curves { one, each };

/// `Count` vectors of scalars, for steps that do not wait for each other.
template <class ScalarT, int Count, Curves Which = Curves::one>
class Lanes {
 public:
  using Scalar = ScalarT;
  using Shared = Same<Scalar>;
  using Tag = hn::ScalableTag<Scalar>;
  using Vector = hn::Vec<Tag>;
  using Mask = LaneMask<Scalar, Count>;
  static constexpr int axes = 1;
  static constexpr bool reads_curves = Which == Curves::one;
  static constexpr int largest_degree = Which == Curves::one ? max_degree : max_degree_of_groups;
  static constexpr std::size_t per_vector = HWY_LANES(Scalar);
  static constexpr std::size_t size = per_vector * Count;

  HWY_INLINE Lanes() {}  // NOLINT(modernize-use-equals-default): uninitialised, like a double
  /// The same value in all lanes.
  HWY_INLINE explicit Lanes(Scalar value) {
    const Vector all = hn::Set(Tag(), value);
    *this = each([&](int /*k*/) { return all; });
  }
  template <std::integral Whole>
  HWY_INLINE explicit Lanes(Whole value) : Lanes(static_cast<Scalar>(value)) {}
  HWY_INLINE Lanes(const Shared& value) : Lanes(value.value()) {}  // NOLINT(google-explicit-constructor): as a double
  /// A coordinate that all lanes share.
  static HWY_INLINE Lanes read(const Scalar* coordinate) { return Lanes(*coordinate); }
  /// Reads `size` values.
  static HWY_INLINE Lanes load(const Scalar* values) {
    return each([&](int k) { return hn::LoadU(Tag(), values + static_cast<std::size_t>(k) * per_vector); });
  }
  HWY_INLINE void store(Scalar* values) const { store(values, All()); }
  friend HWY_INLINE Scalar lane_of(const Lanes& lanes, std::size_t lane) {
    Scalar values[size];
    lanes.store(values);
    return values[lane];
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
    static_assert(HWY_NATIVE_FMA != 0 && Count > 0);  // Count: decided only where this is instantiated
    return each([&](int k) { return hn::MulAdd(vector_[k], b.vector_[k], c.vector_[k]); });
  }

  friend HWY_INLINE Lanes abs(const Lanes& a) {
    return each([&](int k) { return hn::Abs(a.vector_[k]); });
  }
  friend HWY_INLINE Lanes sqrt(const Lanes& a) {
    return each([&](int k) { return hn::Sqrt(a.vector_[k]); });
  }

  friend HWY_INLINE Mask operator<=(const Lanes& a, const Lanes& b) { return less_equal(a, b, All()); }
  friend HWY_INLINE Mask operator<(const Lanes& a, const Lanes& b) { return less(a, b, All()); }
  /// `result`, but in lanes where it is NaN, which should be few, what `settle` says of their t.
  template <class Settle>
  friend HWY_INLINE Lanes or_else(const Lanes& result, const Lanes& t, const Settle& settle) {
    if (all_of(result <= result)) return result;
    Scalar results[size];
    Scalar parameters[size];
    result.store(results);
    t.store(parameters);
    for (std::size_t lane = 0; lane < size; ++lane)
      if (!(results[lane] <= results[lane])) results[lane] = settle(parameters[lane]);
    return load(results);
  }
  friend HWY_INLINE Lanes select(const Mask& condition, const Lanes& first, const Lanes& second) {
    return each([&](int k) { return hn::IfThenElse(condition.mask[k], first.vector_[k], second.vector_[k]); });
  }
  /// `value` in the lanes where `condition` holds, `otherwise(lane)` in the others, which are rare.
  template <class Otherwise>
  friend HWY_INLINE Lanes value_or(const Mask& condition, const Lanes& value, const Otherwise& otherwise) {
    if (all_of(condition)) return value;
    Scalar holds[size];
    select(condition, Lanes(Scalar(1)), Lanes(Scalar(0))).store(holds);
    Scalar values[size];
    value.store(values);
    for (std::size_t lane = 0; lane < size; ++lane)
      if (holds[lane] == 0) values[lane] = otherwise(lane);
    return load(values);
  }

 private:
  using All = std::make_integer_sequence<int, Count>;

  /// Written out one by one: GCC unrolls the loop over the vectors too late to keep them in registers.
  template <class Of>
  static HWY_INLINE Lanes each(const Of& of) {
    return each(of, All());
  }
  template <class Of, int... K>
  static HWY_INLINE Lanes each(const Of& of, std::integer_sequence<int, K...> /*all*/) {
    Lanes result;
    ((result.vector_[K] = of(K)), ...);
    return result;
  }
  template <int... K>
  HWY_INLINE void store(Scalar* values, std::integer_sequence<int, K...> /*all*/) const {
    (hn::StoreU(vector_[K], Tag(), values + K * per_vector), ...);
  }
  template <int... K>
  static HWY_INLINE Mask less_equal(const Lanes& a, const Lanes& b, std::integer_sequence<int, K...> /*all*/) {
    return {{hn::Le(a.vector_[K], b.vector_[K])...}};
  }
  template <int... K>
  static HWY_INLINE Mask less(const Lanes& a, const Lanes& b, std::integer_sequence<int, K...> /*all*/) {
    return {{hn::Lt(a.vector_[K], b.vector_[K])...}};
  }

  Vector vector_[Count];
};

}  // namespace bezierbench::batch::HWY_NAMESPACE
