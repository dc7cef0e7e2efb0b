// SPDX-License-Identifier: MIT
// The one vector scalar: several numbers whose arithmetic is that of the compiler's vectors. Instantiated with it, a
// method's own header evaluates all axes of a point at once (core/evaluate/kernel/points/axes.hpp), or many points
// (core/batch/lanes.hpp). Its `Kind` says how many numbers they are, and how a coefficient is read.
//
// Every lane performs the IEEE operations of the method in the same order, and has the same bits. The payload of a NaN
// may differ.
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "core/curve_view.hpp"
#include "core/vector/lane_choice.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // of vectors that the target does not have; none leaves the unit that made it
#endif

namespace bezierbench {

namespace detail {

template <class Number, int Lanes>
struct VectorType {
  using Type [[gnu::vector_size(sizeof(Number) * Lanes)]] = Number;
  /// The same in memory. For more than 16 bytes, std::memcpy would keep GCC from holding a vector in a register.
  using InMemory [[gnu::vector_size(sizeof(Number) * Lanes), gnu::aligned(alignof(Number)), gnu::may_alias]] = Number;
};
template <class Number>
struct VectorType<Number, 1> {
  using Type = Number;
  using InMemory = Number;
};

/// Several vectors, with the operations of one, written out: GCC unrolls loops over them too late to keep them in
/// registers, and copies an aggregate in pieces of a few bytes.
template <class Vector, int Count>
class Several {
  using All = std::make_integer_sequence<int, Count>;

 public:
  [[gnu::always_inline]] Several() {}  // NOLINT(modernize-use-equals-default): uninitialised, like a double
  [[gnu::always_inline]] Several(const Several& other) {
    set([&](int k) { return other[k]; });
  }
  [[gnu::always_inline]] Several& operator=(const Several& other) {
    set([&](int k) { return other[k]; });
    return *this;
  }
  ~Several() = default;
  /// of(0), of(1), ...
  template <class Of>
  [[gnu::always_inline]] void set(const Of& of) {
    set(of, All());
  }
  [[gnu::always_inline]] const Vector& operator[](int k) const { return vectors_[k]; }

  [[gnu::always_inline]] friend Several operator+(const Several& a, const Several& b) {
    return made([&](int k) { return a[k] + b[k]; });
  }
  [[gnu::always_inline]] friend Several operator-(const Several& a, const Several& b) {
    return made([&](int k) { return a[k] - b[k]; });
  }
  [[gnu::always_inline]] friend Several operator*(const Several& a, const Several& b) {
    return made([&](int k) { return a[k] * b[k]; });
  }
  [[gnu::always_inline]] friend Several operator/(const Several& a, const Several& b) {
    return made([&](int k) { return a[k] / b[k]; });
  }
  [[gnu::always_inline]] friend Several operator-(const Several& a) {
    return made([&](int k) { return -a[k]; });
  }
  [[gnu::always_inline]] friend Several operator&(const Several& a, const Several& b) {
    return made([&](int k) { return a[k] & b[k]; });
  }
  [[gnu::always_inline]] friend Several operator|(const Several& a, const Several& b) {
    return made([&](int k) { return a[k] | b[k]; });
  }
  [[gnu::always_inline]] friend auto operator<(const Several& a, const Several& b) {
    return compared([&](int k) { return a[k] < b[k]; });
  }
  [[gnu::always_inline]] friend auto operator<=(const Several& a, const Several& b) {
    return compared([&](int k) { return a[k] <= b[k]; });
  }

 private:
  template <class Of>
  [[gnu::always_inline]] static Several made(const Of& of) {
    Several result;
    result.set(of);
    return result;
  }
  template <class Of>
  [[gnu::always_inline]] static auto compared(const Of& of) {
    Several<decltype(Vector{} < Vector{}), Count> result;
    result.set(of);
    return result;
  }
  template <class Of, int... K>
  [[gnu::always_inline]] void set(const Of& of, std::integer_sequence<int, K...> /*all*/) {
    ((vectors_[K] = of(K)), ...);
  }

  Vector vectors_[Count];
};

template <class Vector, int Count>
using OneOrSeveral = std::conditional_t<Count == 1, Vector, Several<Vector, Count>>;

template <class Vector>
[[gnu::always_inline]] inline const Vector& vector_of(const Vector& one, int /*k*/) {
  return one;
}
template <class Vector, int Count>
[[gnu::always_inline]] inline const Vector& vector_of(const Several<Vector, Count>& several, int k) {
  return several[k];
}

}  // namespace detail

/// A vector extension of the compiler, which makes several of one that the processor does not have.
template <class Number, int Lanes>
using VectorOf = typename detail::VectorType<Number, Lanes>::Type;

/// How a curve over a vector scalar holds its coefficients.
enum class Held {
  by_reference,  ///< it is a view of numbers
  by_value       ///< it owns them
};

/// The vectors of a Kind, whose steps do not wait for each other. It has
///   Scalar, Shared       one number, and the type of a value that all curves share (core/vector/shared.hpp);
///   lanes, vectors       the numbers of a vector, and how many vectors there are;
///   axes                 how many coordinates of a point are in the lanes;
///   numbers              how many lanes hold numbers of the caller's;
///   shares_t             whether t is the same in all lanes: what depends on it only then compares as a number does;
///   largest_degree       of the curves that own their coefficients;
///   read(first)          reads a coefficient into a vector;
///   fused(a, b, c), square_root(a), all(truths), any(truths)    of one vector.
template <class KindT, Held held>
class Vectors {
 public:
  using Kind = KindT;
  using Scalar = typename Kind::Scalar;
  using Shared = typename Kind::Shared;
  using Vector = VectorOf<Scalar, Kind::lanes>;
  static constexpr int axes = Kind::axes;
  static constexpr bool reads_curves = held == Held::by_reference;
  static constexpr int largest_degree = reads_curves ? max_degree : Kind::largest_degree;
  static constexpr std::size_t size = static_cast<std::size_t>(Kind::lanes) * Kind::vectors;

  /// A truth value for each lane.
  struct Mask {
    using Truths = decltype(Vector{} < Vector{});
    detail::OneOrSeveral<Truths, Kind::vectors> truths;

    // NOLINTNEXTLINE(google-explicit-constructor): what a comparison of scalars is
    [[gnu::always_inline]] operator bool() const requires(Kind::shares_t) {
      if constexpr (Kind::lanes == 1)
        return truths;
      else
        return truths[0] != 0;
    }
    [[gnu::always_inline]] friend Mask both(const Mask& a, const Mask& b) { return {a.truths & b.truths}; }
    [[gnu::always_inline]] friend Mask either(const Mask& a, const Mask& b) { return {a.truths | b.truths}; }
    [[gnu::always_inline]] friend bool all_of(const Mask& mask) {
      Truths all = detail::vector_of(mask.truths, 0);
      for (int k = 1; k < Kind::vectors; ++k) all = all & detail::vector_of(mask.truths, k);
      return Kind::all(all);
    }
    [[gnu::always_inline]] friend bool any_of(const Mask& mask) {
      Truths any = detail::vector_of(mask.truths, 0);
      for (int k = 1; k < Kind::vectors; ++k) any = any | detail::vector_of(mask.truths, k);
      return Kind::any(any);
    }
  };

  [[gnu::always_inline]] Vectors() {}  // NOLINT(modernize-use-equals-default): uninitialised, like a double
  /// The same value in all lanes.
  [[gnu::always_inline]] Vectors(Scalar value) {  // NOLINT(google-explicit-constructor): as a number
    const Vector all = value - Vector{};
    *this = each([&](int /*k*/) { return all; });
  }
  template <std::integral Integer>
  [[gnu::always_inline]] explicit Vectors(Integer value) : Vectors(static_cast<Scalar>(value)) {}
  [[gnu::always_inline]] Vectors(const Shared& value) requires(!std::same_as<Shared, Scalar>)
      : Vectors(value.value()) {}  // NOLINT(google-explicit-constructor): as a number

  /// Reads one coefficient.
  [[gnu::always_inline]] static Vectors read(const Scalar* first) {
    return each([&](int /*k*/) { return Kind::read(first); });
  }
  /// Reads a value for each lane.
  [[gnu::always_inline]] static Vectors load(const Scalar* values) {
    return each([&](int k) { return Vector(*reinterpret_cast<const InMemory*>(values + k * Kind::lanes)); });
  }
  /// Writes the first `Count` lanes.
  template <int Count = Kind::numbers>
  [[gnu::always_inline]] void store(Scalar* values) const {
    static_assert(Count <= Kind::numbers);
    if constexpr (Count == Kind::lanes * Kind::vectors)
      store_all(values, All());
    else
      for (int k = 0; k < Count; ++k) values[k] = lane(k);
  }
  [[nodiscard, gnu::always_inline]] Scalar lane(int k) const {
    if constexpr (Kind::lanes == 1)
      return detail::vector_of(vectors_, k);
    else
      return detail::vector_of(vectors_, k / Kind::lanes)[k % Kind::lanes];
  }

  [[gnu::always_inline]] friend Vectors operator+(const Vectors& a, const Vectors& b) {
    return of(a.vectors_ + b.vectors_);
  }
  [[gnu::always_inline]] friend Vectors operator-(const Vectors& a, const Vectors& b) {
    return of(a.vectors_ - b.vectors_);
  }
  [[gnu::always_inline]] friend Vectors operator*(const Vectors& a, const Vectors& b) {
    return of(a.vectors_ * b.vectors_);
  }
  [[gnu::always_inline]] friend Vectors operator/(const Vectors& a, const Vectors& b) {
    return of(a.vectors_ / b.vectors_);
  }
  [[gnu::always_inline]] friend Vectors operator-(const Vectors& a) { return of(-a.vectors_); }
  [[gnu::always_inline]] Vectors& operator+=(const Vectors& b) { return *this = *this + b; }
  [[gnu::always_inline]] Vectors& operator*=(const Vectors& b) { return *this = *this * b; }
  [[gnu::always_inline]] Vectors& operator/=(const Vectors& b) { return *this = *this / b; }

  /// *this b + c with one rounding.
  [[nodiscard, gnu::always_inline]] Vectors fused(const Vectors& b, const Vectors& c) const {
    if constexpr (Kind::vectors == 1)
      return of(Kind::fused(vectors_, b.vectors_, c.vectors_));
    else
      return each([&](int k) { return Kind::fused(vectors_[k], b.vectors_[k], c.vectors_[k]); });
  }
  [[gnu::always_inline]] friend Vectors sqrt(const Vectors& a) {
    return each([&](int k) { return Kind::square_root(detail::vector_of(a.vectors_, k)); });
  }
  [[gnu::always_inline]] friend Vectors abs(const Vectors& a) {
    return each([&](int k) {
      const Vector& vector = detail::vector_of(a.vectors_, k);
      if constexpr (Kind::lanes == 1) {
        return std::abs(vector);
      } else {
        using Bits = typename Mask::Truths;
        return std::bit_cast<Vector>(std::bit_cast<Bits>(vector) & ~std::bit_cast<Bits>(-Vector{}));
      }
    });
  }

  [[gnu::always_inline]] friend Mask operator<=(const Vectors& a, const Vectors& b) {
    return {a.vectors_ <= b.vectors_};
  }
  [[gnu::always_inline]] friend Mask operator<(const Vectors& a, const Vectors& b) { return {a.vectors_ < b.vectors_}; }
  [[gnu::always_inline]] friend Vectors select(const Mask& condition, const Vectors& first, const Vectors& second) {
    return each([&](int k) {
      return detail::vector_of(condition.truths, k) ? detail::vector_of(first.vectors_, k)
                                                    : detail::vector_of(second.vectors_, k);
    });
  }
  /// Lanes 1, 2, ... of a, then lane 0 of b.
  [[gnu::always_inline]] friend Vectors shifted(const Vectors& a, const Vectors& b) requires(Kind::vectors == 1) {
    return shifted(a, b, std::make_integer_sequence<int, Kind::lanes>());
  }

 private:
  using All = std::make_integer_sequence<int, Kind::vectors>;
  using InMemory = typename detail::VectorType<Scalar, Kind::lanes>::InMemory;
  using Registers = detail::OneOrSeveral<Vector, Kind::vectors>;

  [[gnu::always_inline]] static Vectors of(const Registers& vectors) {
    Vectors result;
    result.vectors_ = vectors;
    return result;
  }
  /// of(0), of(1), ...
  template <class Of>
  [[gnu::always_inline]] static Vectors each(const Of& of) {
    Vectors result;
    if constexpr (Kind::vectors == 1)
      result.vectors_ = of(0);
    else
      result.vectors_.set(of);
    return result;
  }
  template <int... K>
  [[gnu::always_inline]] void store_all(Scalar* values, std::integer_sequence<int, K...> /*all*/) const {
    ((*reinterpret_cast<InMemory*>(values + K * Kind::lanes) = detail::vector_of(vectors_, K)), ...);
  }
  template <int... Lane>
  [[gnu::always_inline]] static Vectors shifted(const Vectors& a, const Vectors& b,
                                                std::integer_sequence<int, Lane...> /*all*/) {
    return of(__builtin_shufflevector(a.vectors_, b.vectors_, (Lane + 1)...));
  }

  Registers vectors_;
};

}  // namespace bezierbench
