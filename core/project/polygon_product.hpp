// SPDX-License-Identifier: MIT
// f = (C - P).C' / n in Bernstein form, degree 2n-1, and the signs of its coefficients where they are certain:
//   f_k = sum_(i+j=k) C(n,i) C(n-1,j) / C(2n-1,k) (b_i - P).(b_(j+1) - b_j).
//
// Source: [Farouki and Rajan 1988], products in Bernstein form.
#pragma once

#include "core/binomial.hpp"
#include "core/project/halved_polygon.hpp"
#include "core/project/written_out_product.hpp"

namespace bezierbench {

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
