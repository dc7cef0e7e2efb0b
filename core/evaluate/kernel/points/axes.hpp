// SPDX-License-Identifier: MIT
// The coordinates of one point side by side in a vector, as one scalar: instantiated with it, in one dimension, a
// method's own header evaluates all axes of a point at once. What depends on t only is the same in every lane.
//
// Every lane performs the IEEE operations of the method on its axis in the same order, and has the same bits. The
// payload of a NaN may differ. Lanes beyond the dimension are 0 in coefficients.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <utility>

#include "core/evaluate/schemes/steps.hpp"
#include "core/evaluate/schemes/triangle.hpp"
#include "core/vector/lane_choice.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // of vectors that the target does not have; none leaves the unit that made it
#endif

namespace bezierbench {

namespace detail {

/// One lane for one axis, else the least power of two that holds all axes and fills 16 bytes.
template <class Scalar>
constexpr int lanes_for(int axes) {
  if (axes == 1) return 1;
  int lanes = 16 / static_cast<int>(sizeof(Scalar));
  while (lanes < axes) lanes *= 2;
  return lanes;
}

/// A vector extension of the compiler, which makes several of one that the processor does not have.
template <class Scalar, int Lanes>
struct VectorType {
  using Type [[gnu::vector_size(sizeof(Scalar) * Lanes)]] = Scalar;
};
template <class Scalar>
struct VectorType<Scalar, 1> {
  using Type = Scalar;
};

/// a b + c with one rounding in each lane: an instruction where the compiled target has one.
template <class Vector>
Vector fused_vectors(const Vector& a, const Vector& b, const Vector& c) {
  Vector result;
  for (std::size_t lane = 0; lane < sizeof(Vector) / sizeof(a[0]); ++lane)
    result[lane] = std::fma(a[lane], b[lane], c[lane]);
  return result;
}
#ifdef __FMA__
inline auto fused_vectors(const VectorType<double, 2>::Type& a, const VectorType<double, 2>::Type& b,
                          const VectorType<double, 2>::Type& c) {
  return __builtin_ia32_vfmaddpd(a, b, c);
}
inline auto fused_vectors(const VectorType<double, 4>::Type& a, const VectorType<double, 4>::Type& b,
                          const VectorType<double, 4>::Type& c) {
  return __builtin_ia32_vfmaddpd256(a, b, c);
}
inline auto fused_vectors(const VectorType<float, 4>::Type& a, const VectorType<float, 4>::Type& b,
                          const VectorType<float, 4>::Type& c) {
  return __builtin_ia32_vfmaddps(a, b, c);
}
inline auto fused_vectors(const VectorType<float, 8>::Type& a, const VectorType<float, 8>::Type& b,
                          const VectorType<float, 8>::Type& c) {
  return __builtin_ia32_vfmaddps256(a, b, c);
}
#endif

}  // namespace detail

/// How a curve over this scalar holds its coefficients.
enum class Held {
  by_reference,  ///< the curve is a view of a prepared state
  by_value       ///< the curve owns them
};

namespace detail {

/// A curve that is computed shares values among its axes; those of a view lie in its state.
template <class Scalar, Held>
struct SharedByAxes {};
template <class Scalar>
struct SharedByAxes<Scalar, Held::by_value> {
  using Shared = Scalar;
};

}  // namespace detail

/// `Dimension` coordinates.
template <class ScalarT, int Dimension, Held held = Held::by_reference>
class Axes : public detail::SharedByAxes<ScalarT, held> {
 public:
  using Scalar = ScalarT;
  static constexpr int axes = Dimension;
  static constexpr bool reads_curves = held == Held::by_reference;
  static constexpr int lanes = detail::lanes_for<Scalar>(Dimension);
  using Vector = typename detail::VectorType<Scalar, lanes>::Type;

  /// A comparison; as a truth value one of what is the same in every lane.
  struct Mask {
    decltype(Vector{} < Vector{}) value;

    operator bool() const { return holds(0); }  // NOLINT(google-explicit-constructor): what a comparison of scalars is
    [[nodiscard]] bool holds(int axis) const {
      if constexpr (lanes == 1)
        return value;
      else
        return value[axis] != 0;
    }
    friend bool all_of(const Mask& mask) {
      bool all = true;
      for (int axis = 0; axis < Dimension; ++axis) all = all && mask.holds(axis);
      return all;
    }
    friend bool any_of(const Mask& mask) {
      bool any = false;
      for (int axis = 0; axis < Dimension; ++axis) any = any || mask.holds(axis);
      return any;
    }
  };

  Axes() = default;
  /// The same value in all lanes.
  explicit(held == Held::by_reference) Axes(Scalar value) : vector_(value - Vector{}) {}
  template <std::integral Integer>
  explicit Axes(Integer value) : Axes(static_cast<Scalar>(value)) {}

  /// Reads `Dimension` values.
  static Axes read(const Scalar* values) { return read(values, std::make_integer_sequence<int, lanes>()); }
  /// Reads a value for each lane.
  static Axes load_all(const Scalar* values) {
    Axes result;
    std::memcpy(&result.vector_, values, sizeof result.vector_);
    return result;
  }
  /// Writes the first `Count` values.
  template <int Count = Dimension>
  void store(Scalar* values) const {
    static_assert(Count <= Dimension);
    if constexpr (lanes == 1)
      *values = vector_;  // GCC 12 turns memcpy into an integer move and keeps the value in integer registers
    else if constexpr (Count == lanes)
      std::memcpy(values, &vector_, sizeof vector_);
    else
      for (int axis = 0; axis < Count; ++axis) values[axis] = lane(axis);
  }
  [[nodiscard]] Scalar lane(int axis) const {
    if constexpr (lanes == 1)
      return vector_;
    else
      return vector_[axis];
  }

  friend Axes operator+(const Axes& a, const Axes& b) { return of(a.vector_ + b.vector_); }
  friend Axes operator-(const Axes& a, const Axes& b) { return of(a.vector_ - b.vector_); }
  friend Axes operator*(const Axes& a, const Axes& b) { return of(a.vector_ * b.vector_); }
  friend Axes operator/(const Axes& a, const Axes& b) { return of(a.vector_ / b.vector_); }
  friend Axes operator-(const Axes& a) { return of(-a.vector_); }
  Axes& operator+=(const Axes& b) { return *this = *this + b; }
  Axes& operator*=(const Axes& b) { return *this = *this * b; }
  Axes& operator/=(const Axes& b) { return *this = *this / b; }

  /// *this b + c with one rounding.
  [[nodiscard]] Axes fused(const Axes& b, const Axes& c) const {
    if constexpr (lanes == 1)
      return of(std::fma(vector_, b.vector_, c.vector_));
    else
      return of(detail::fused_vectors(vector_, b.vector_, c.vector_));
  }

  friend Mask operator<=(const Axes& a, const Axes& b) { return {a.vector_ <= b.vector_}; }
  friend Axes select(const Mask& condition, const Axes& first, const Axes& second) {
    return of(condition.value ? first.vector_ : second.vector_);
  }
  /// Lanes 1, 2, ... of a, then lane 0 of b.
  friend Axes shifted(const Axes& a, const Axes& b) { return shifted(a, b, std::make_integer_sequence<int, lanes>()); }
  /// These two take a value that is the same in every lane, as a parameter is.
  friend Scalar parameter_of(const Axes& t) { return t.lane(0); }
  friend bool inside_unit_interval(const Axes& t) { return bezierbench::inside_unit_interval<Scalar>(t.lane(0)); }

 private:
  static Axes of(const Vector& vector) {
    Axes result;
    result.vector_ = vector;
    return result;
  }
  template <int... Lane>
  friend Axes shifted(const Axes& a, const Axes& b, std::integer_sequence<int, Lane...> /*all*/) {
    return of(__builtin_shufflevector(a.vector_, b.vector_, (Lane + 1)...));
  }
  template <int... Lane>
  static Axes read(const Scalar* values, std::integer_sequence<int, Lane...> /*all*/) {
    return of(Vector{(Lane < Dimension ? values[Lane] : Scalar(0))...});
  }

  Vector vector_;
};

template <class Scalar, int Dimension>
inline constexpr bool writes_out_steps<Axes<Scalar, Dimension>> = true;
template <class Scalar, int Dimension>
inline constexpr TriangleOrder triangle_order<Axes<Scalar, Dimension>>{.width = 4, .ends_in_registers = true};

}  // namespace bezierbench
