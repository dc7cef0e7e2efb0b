// SPDX-License-Identifier: MIT
// f = (C - P).C' / n in Bernstein form, degree 2n-1, and the signs of its coefficients where they are certain:
//   f_k = sum_(i+j=k) C(n,i) C(n-1,j) / C(2n-1,k) (b_i - P).(b_(j+1) - b_j).
//
// Source: [Farouki and Rajan 1988], products in Bernstein form.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "core/binomial.hpp"
#include "core/project/polygon.hpp"
#include "core/vector/vectors.hpp"

namespace bezierbench {

// The sums of a product in Bernstein form for one degree: the products of one b_i - P with all
// differences lie side by side in a vector. The bits are those of the sums one by one: an element adds the same numbers
// in the same order, and zeros.

/// The product for a curve of degree n = 2 or 3. It has 2n coefficients, and its sums are written out.
template <int Dimension, int Degree>
class WrittenOutProduct {
  static_assert(Degree == 2 || Degree == 3);

 public:
  /// C(2n-1,k) f_k from b_i - P, b_(j+1) - b_j and the binomials C(n,i) and C(n-1,j).
  template <class CurveRow, class DifferenceRow>
  static Polygon<1, 2 * Degree> sums(const Polygon<Dimension, Degree + 1>& offset,
                                     const Polygon<Dimension, Degree>& difference, const CurveRow& curve_binomials,
                                     const DifferenceRow& difference_binomials) {
    std::array<Four, Dimension> differences;
    for (int axis = 0; axis < Dimension; ++axis)
      differences[static_cast<std::size_t>(axis)] = first_of([&](int j) { return difference(axis, j); });
    const Four binomials = first_of([&](int j) { return difference_binomials[j]; });
    Sums sums;
    [&]<int... I>(std::integer_sequence<int, I...> /*all*/) {
      (sums.template add<I>(curve_binomials[I] * binomials * dots(offset.col(I), differences)), ...);
    }
    (std::make_integer_sequence<int, Degree + 1>());
    return sums.all();
  }

 private:
  using Four = VectorOf<double, 4>;

  template <class Element>
  static Four first_of(const Element& element) {
    Four result{};
    for (int j = 0; j < Degree; ++j) result[j] = element(j);
    return result;
  }

  /// a.b for the vectors b whose coordinates on each axis lie side by side.
  static Four dots(const Point<double, Dimension>& a, const std::array<Four, Dimension>& b) {
    Four sum = a[0] * b[0];
    for (std::size_t axis = 1; axis < Dimension; ++axis) sum += a[static_cast<int>(axis)] * b[axis];
    return sum;
  }

  /// Eight sums, the first of which are used.
  struct Sums {
    Four low{};
    Four high{};

    /// Adds the elements of `terms` to the sums from number First on.
    template <int First>
    void add(const Four& terms) {
      const Four zeros{};
      if constexpr (First == 0)
        low += terms;
      else
        low +=
            __builtin_shufflevector(zeros, terms, place(First, 0), place(First, 1), place(First, 2), place(First, 3));
      if constexpr (First + Degree > 4)
        high +=
            __builtin_shufflevector(zeros, terms, place(First, 4), place(First, 5), place(First, 6), place(First, 7));
    }
    [[nodiscard]] Polygon<1, 2 * Degree> all() const {
      Polygon<1, 2 * Degree> result;
      std::memcpy(result.data(), &low, sizeof low);
      if constexpr (Degree == 3) std::memcpy(result.data() + 4, &high, 2 * sizeof(double));
      return result;
    }

   private:
    /// Where the term of sum k stands in a pair of zeros and terms whose first one belongs to sum `first`.
    static constexpr int place(int first, int k) { return k >= first && k < first + 4 ? 4 + k - first : 0; }
  };
};

// A control polygon under repeated halving, with a running bound of the rounding errors that halving has added.

template <int Dimension, int Points = dynamic>
struct HalvedPolygon {
  Polygon<Dimension, Points> b;
  double largest = 0;  ///< the largest magnitude of a coordinate
  double error = 0;    ///< bound of the error of every coordinate

  HalvedPolygon() = default;
  /// Takes points that were rounded once.
  explicit HalvedPolygon(const Polygon<Dimension, Points>& rounded)
      : b(rounded), largest(largest_coordinate<Dimension>(b)), error(0x1p-53 * largest) {}
};

/// Sets the polygons over [0, 1/2] and [1/2, 1]. gnu::flatten: points stay in registers until their magnitudes are
/// compared.
template <int Dimension, int Points>
[[gnu::flatten]] void halve(const HalvedPolygon<Dimension, Points>& polygon, HalvedPolygon<Dimension, Points>& left,
                            HalvedPolygon<Dimension, Points>& right) {
  halve<Dimension>(polygon.b, left.b, right.b);
  left.largest = largest_coordinate<Dimension>(left.b);
  right.largest = largest_coordinate<Dimension>(right.b);
  left.error = right.error = polygon.error + 0x1p-53 * static_cast<double>(polygon.b.cols()) * polygon.largest;
}

/// A polynomial in Bernstein form with a bound of the errors of its coefficients. Coefficients are divided by their
/// binomials only on request: most pieces are judged without.
template <int Count = dynamic>
struct UncertainPolynomial {
  Polygon<1, Count> weighted;  ///< coefficient k times C(degree,k)
  const double* binomials;     ///< C(degree,k), not owned
  double error;                ///< bound of the error of every coefficient

  [[nodiscard]] int degree() const { return degree_of<1>(weighted); }
  [[nodiscard]] double coefficient(int k) const { return weighted[k] / binomials[k]; }
  [[nodiscard]] Polygon<1, Count> coefficients() const {
    Polygon<1, Count> result;
    result.resize(1, weighted.cols());
    for (int k = 0; k <= degree(); ++k) result[k] = coefficient(k);
    return result;
  }
  /// The sign of coefficient k; 0 where the error makes it uncertain.
  [[nodiscard]] int sign(int k) const {
    const bool at_end = k == 0 || k == degree();  // where the binomial is 1
    const double value = at_end ? weighted[k] : coefficient(k);
    return value > error ? 1 : value < -error ? -1 : 0;
  }
  /// True if no sign is certain.
  [[nodiscard]] bool is_unknown() const { return sign(0) == 0 && largest_coordinate<1>(coefficients()) <= error; }

  /// The largest number of sign variations over all choices for the uncertain signs.
  [[nodiscard]] int max_variations() const { return is_surely_certain() ? variations() : max_variations_of_choices(); }

 private:
  [[nodiscard]] int max_variations_of_choices() const {
    const int none = -degree() - 2;
    int after_plus = -1;  // two values for which the first sign is not a variation
    int after_minus = -1;
    for (int k = 0; k <= degree(); ++k) {
      const int plus = sign(k) < 0 ? none : std::max(after_plus, after_minus + 1);
      const int minus = sign(k) > 0 ? none : std::max(after_minus, after_plus + 1);
      after_plus = plus;
      after_minus = minus;
    }
    return std::max(after_plus, after_minus);
  }
  /// True only if all signs are certain; the margin covers the roundings of both sides.
  [[nodiscard]] bool is_surely_certain() const {
    const double least = error * (1 + 0x1p-50);
    bool certain = true;
    each<Count>(degree() + 1, [&](int k) { certain &= std::abs(weighted[k]) > least * binomials[k]; });
    return certain;
  }
  /// The number of sign variations where all signs are certain.
  [[nodiscard]] int variations() const {
    int count = 0;
    each<count_of(Count, -1)>(degree(), [&](int k) {
      count += static_cast<int>(std::signbit(weighted[k]) != std::signbit(weighted[k + 1]));
    });
    return count;
  }
};

/// Multiplies polygons of degrees n and n - 1, for one n.
template <int Degree = dynamic>
class PolygonProduct {
 public:
  explicit PolygonProduct(int n) : curve_binomials_(n), difference_binomials_(n - 1), product_binomials_(2 * n - 1) {}

  template <int Dimension>
  [[nodiscard]] UncertainPolynomial<count_of(Degree, Degree)> operator()(
      const HalvedPolygon<Dimension, count_of(Degree, 1)>& offset,
      const HalvedPolygon<Dimension, Degree>& difference) const {
    if constexpr (Degree == dynamic)
      return {sums<Dimension>(offset.b, difference.b), &product_binomials_[0], error_of(offset, difference)};
    else
      return {
          WrittenOutProduct<Dimension, Degree>::sums(offset.b, difference.b, curve_binomials_, difference_binomials_),
          &product_binomials_[0], error_of(offset, difference)};
  }

 private:
  /// C(2n-1,k) f_k.
  template <int Dimension>
  Polygon<1> sums(const Polygon<Dimension>& offset, const Polygon<Dimension>& difference) const {
    const int n = degree_of<Dimension>(offset);
    Polygon<1> f = Polygon<1>::Zero(1, 2 * n);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j < n; ++j)
        f[i + j] += curve_binomials_[i] * difference_binomials_[j] * dot<Dimension>(offset.col(i), difference.col(j));
    return f;
  }

  /// A bound of the errors of the coefficients: the errors of the polygons, carried through the products, at most d + 1
  /// roundings in a product of vectors, 2n + 4 in weighting and summing, and 3n in binomials that are not exact.
  template <int Dimension>
  static double error_of(const HalvedPolygon<Dimension, count_of(Degree, 1)>& offset,
                         const HalvedPolygon<Dimension, Degree>& difference) {
    const double largest_offset = offset.largest + offset.error;
    const double largest_difference = difference.largest + difference.error;
    const double roundings = 0x1p-53 * (5.0 * static_cast<double>(offset.b.cols()) + Dimension + 5);
    const double carried = offset.error * largest_difference + difference.error * largest_offset;
    return Dimension * (1 + 0x1p-20) * (carried + roundings * largest_offset * largest_difference);
  }

  BinomialRow<double, Degree> curve_binomials_;
  BinomialRow<double, count_of(Degree, -1)> difference_binomials_;
  BinomialRow<double, count_of(Degree, Degree - 1)> product_binomials_;
};

}  // namespace bezierbench
