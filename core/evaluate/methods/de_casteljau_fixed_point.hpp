// SPDX-License-Identifier: MIT
// Formula: x_i = min(X, fl(C + fl(s b_i - s l))), x_i^k = fma(t, x_(i+1)^(k-1) - x_i^(k-1), x_i^(k-1)),
//   p(t) = fma(1/s, x_0^n - C, l) inside (0,1), else b_0 or b_n. For each axis l and h are the least and the largest
//   b_i, s = 1, or 1/8 where some b_i is next to overflow, C is the least normal power of two that is not below
//   fl(s h - s l), and X is fl(C + fl(s h - s l)), or the number below it where else p would exceed h.
// Source: adding a power of two leaves multiples of its last place.
// Bound: none relative to p~, but u |p| + (2n+4) u (1 + 4u) (h - l), and n eta/2 where h - l is subnormal.
//   docs/proofs/de_casteljau_fixed_point.md has the proof.
// Keeps: ends_exact, constant_reproduced, in_hull, monotone, reversal, scaling_by_two, axes_independent, finite, total,
//   because a step is (1-t) a + t b rounded once; proved there, too.
// Fails: a result far smaller than h - l has few correct bits. The points -b_i need not give -p. t outside [0,1] gives
//   the nearer end.
#pragma once

#include <array>
#include <tuple>

#include "core/error_free.hpp"
#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/schemes/triangle.hpp"
#include "core/powers.hpp"
#include "core/vector/lane_choice.hpp"

namespace bezierbench {

/// What fixed-point evaluation needs of an axis beside the x_i.
enum class FixedPointValue { first, last, least, offset, inverse_scale };
inline constexpr int fixed_point_values = 5;

/// These values for all axes, value by value: the axes of one side by side, and 0 up to a number of them that fills a
/// vector.
template <class Scalar, int Dimension>
class FixedPointFrame {
 public:
  static constexpr int stride = Dimension == 1 ? 1 : 4;

  /// Sets the elements that belong to no axis to 0. An initialiser of `values_` would do that, too, but then GCC sets
  /// the whole prepared state to 0: 8 KB for each axis.
  FixedPointFrame() {
    for (int k = 0; k < fixed_point_values; ++k)
      for (int axis = Dimension; axis < stride; ++axis) (*this)(axis, static_cast<FixedPointValue>(k)) = Scalar(0);
  }

  [[nodiscard]] const Scalar& operator()(int axis, FixedPointValue value) const { return values_[at(axis, value)]; }
  [[nodiscard]] Scalar& operator()(int axis, FixedPointValue value) { return values_[at(axis, value)]; }
  [[nodiscard]] const Scalar* data() const { return values_.data(); }

 private:
  static std::size_t at(int axis, FixedPointValue value) {
    return static_cast<std::size_t>(static_cast<int>(value) * stride + axis);
  }
  std::array<Scalar, static_cast<std::size_t>(fixed_point_values* stride)> values_;
};

template <ReadsCurves V, int Dimension>
class FixedPointFrame<V, Dimension> {
 public:
  explicit FixedPointFrame(const typename V::Scalar* first) : first_(first) {}
  [[nodiscard, gnu::always_inline]] V operator()(int axis, FixedPointValue value) const {
    constexpr int stride = FixedPointFrame<typename V::Scalar, Dimension * V::axes>::stride;
    return V::read(first_ + static_cast<int>(value) * stride + axis);
  }

 private:
  const typename V::Scalar* first_;
};

struct DeCasteljauFixedPoint {
  static constexpr MethodInfo info{.id = "de_casteljau_fixed_point",
                                   .label = "de Casteljau, fixed point",
                                   .form = Form::bernstein,
                                   .unit_interval_only = true,
                                   .fused = true,
                                   .flops = "d(n(n+1) + 2)",
                                   .cost_exponent = 2,
                                   .citation = "[Rump et al. 2008], section 3, for the offset; bound derived here"};
  static constexpr LaneRegisters lanes{.per_axis = 0, .shared = 6, .one_curve_only = true};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact},
                                         Guarantee{Property::constant_reproduced},
                                         Guarantee{Property::in_hull},
                                         Guarantee{Property::monotone},
                                         Guarantee{Property::reversal},
                                         Guarantee{Property::scaling_by_two},
                                         Guarantee{Property::axes_independent},
                                         Guarantee{Property::finite},
                                         Guarantee{Property::total}};

  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::bernstein, Scalar, Dimension, Degree> fixed;  ///< the x_i
    FixedPointFrame<Scalar, Dimension> frame;

    [[nodiscard]] auto parts() const { return std::tie(fixed, frame); }
  };

  template <class Scalar, int Dimension, int Degree>
  static Prepared<Scalar, Dimension, Degree> prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    Prepared<Scalar, Dimension, Degree> prepared{Curve<Form::bernstein, Scalar, Dimension, Degree>(curve.degree()),
                                                 FixedPointFrame<Scalar, Dimension>()};
    for (int axis = 0; axis < Dimension; ++axis) prepare_axis(curve, axis, prepared);
    return prepared;
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    Point<Scalar, Dimension> point =
        run_triangle(prepared.fixed, [t](Scalar a, Scalar b) { return fused<Scalar>(t, b - a, a); });
    const auto& frame = prepared.frame;
    for (int axis = 0; axis < Dimension; ++axis)
      point[axis] =
          fused<Scalar>(frame(axis, FixedPointValue::inverse_scale), point[axis] - frame(axis, FixedPointValue::offset),
                        frame(axis, FixedPointValue::least));
    if (!all_of(inside_unit_interval(t))) [[unlikely]]
      for (int axis = 0; axis < Dimension; ++axis) {
        const auto from_start = select(t <= Scalar(0), frame(axis, FixedPointValue::first), point[axis]);
        point[axis] = select(Scalar(1) <= t, frame(axis, FixedPointValue::last), from_start);
      }
    return point;
  }

 private:
  template <class Scalar, int Dimension, int Degree>
  static void prepare_axis(const Curve<Form::bernstein, Scalar, Dimension, Degree>& b, int axis,
                           Prepared<Scalar, Dimension, Degree>& prepared) {
    const int n = b.degree();
    Scalar least = b(axis, 0);
    Scalar largest = b(axis, 0);
    for (int i = 1; i <= n; ++i) {
      if (b(axis, i) < least) least = b(axis, i);
      if (largest < b(axis, i)) largest = b(axis, i);
    }
    const bool scaled = is_near_overflow(largest) || is_near_overflow(Scalar(-least));
    const Scalar scale = scaled ? Scalar(0.125) : Scalar(1);
    const Scalar inverse_scale = scaled ? Scalar(8) : Scalar(1);
    const Scalar origin = scale * least;
    const Scalar width = scale * largest - origin;
    const Scalar offset = power_of_two_from(width);
    Scalar top = offset + width;
    if (largest < fused<Scalar>(inverse_scale, top - offset, least)) top = top - last_place_of(offset);
    const std::array frame{b(axis, 0), b(axis, n), least, offset, inverse_scale};
    for (std::size_t k = 0; k < frame.size(); ++k) prepared.frame(axis, static_cast<FixedPointValue>(k)) = frame[k];
    for (int i = 0; i <= n; ++i) {
      const Scalar fixed = offset + (scale * b(axis, i) - origin);
      prepared.fixed(axis, i) = fixed < top ? fixed : top;
    }
  }
};

}  // namespace bezierbench
