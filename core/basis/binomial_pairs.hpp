// SPDX-License-Identifier: MIT
// C(n,i) for one n and all i with twice the precision.
#pragma once

#include "core/basis/binomial_table.hpp"
#include "core/error_free.hpp"

namespace bezierbench {

/// C(n,0..n) as unevaluated sums high + low.
template <class Scalar, int Degree>
struct BinomialPairs {
  PerCoefficient<SharedBy<Scalar>, Degree> high;
  PerCoefficient<SharedBy<Scalar>, Degree> low;
};

/// The row C(n,0..n), split into two Scalars: from the table where that is exact, else by the recurrence of
/// binomial.hpp in double-double.
template <class Scalar, int Degree>
BinomialPairs<Scalar, Degree> binomial_pairs(int n) {
  using Shared = SharedBy<Scalar>;
  BinomialPairs<Scalar, Degree> row{per_coefficient<Shared, Degree>(n), per_coefficient<Shared, Degree>(n)};
  if (n <= exact_binomial_degree) {
    const BinomialRow<double, dynamic> exact(n);
    for (int i = 0; i <= n; ++i) {
      row.high[i] = static_cast<Shared>(exact[i]);
      row.low[i] = static_cast<Shared>(exact[i] - static_cast<double>(row.high[i]));
    }
    return row;
  }
  const double scale = binomial_scale(n);
  Expansion2<double> value{1 / scale, 0};
  for (int i = 0; 2 * i <= n; ++i) {
    if (i > 0) {
      const double factor = n - i + 1;
      const double divisor = i;
      const auto product = two_prod(value.value, factor);
      const auto numerator = fast_two_sum(product.value, product.error + value.error * factor);
      const double quotient = numerator.value / divisor;
      const double remainder = fused(-quotient, divisor, numerator.value);
      value = fast_two_sum(quotient, (remainder + numerator.error) / divisor);
    }
    row.high[i] = static_cast<Shared>(value.value * scale);
    row.low[i] = static_cast<Shared>((value.value * scale - static_cast<double>(row.high[i])) + value.error * scale);
    row.high[n - i] = row.high[i];
    row.low[n - i] = row.low[i];
  }
  return row;
}

/// Relative error of `binomial_pairs<double>` in units of u^2, to first order: in each of at most n/2 steps the low
/// part (at most u) passes four roundings, the error of the product two, that of the quotient two.
constexpr double binomial_pair_roundings(int n) { return n > exact_binomial_degree ? 4.0 * n : 0; }

}  // namespace bezierbench
