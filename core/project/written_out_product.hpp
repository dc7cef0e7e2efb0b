// SPDX-License-Identifier: MIT
// The sums of a product in Bernstein form (polygon_product.hpp) for one degree: the products of one b_i - P with all
// differences lie side by side in a vector. The bits are those of the sums one by one: an element adds the same numbers
// in the same order, and zeros.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "core/project/polygon.hpp"

namespace bezierbench {

/// For curves of degree 2 or 3, whose product has 4 or 6 coefficients.
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
  /// Four numbers in a row, a vector extension of the compiler.
  using Four [[gnu::vector_size(4 * sizeof(double))]] = double;

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

}  // namespace bezierbench
