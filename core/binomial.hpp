// SPDX-License-Identifier: MIT
// C(n,i) for one n and all i, by C(n,i) = C(n,i-1) (n-i+1) / i and symmetry: as a row, as a row for reading, and with
// twice the precision.
//
// Exact in double for n <= 54 (verified for every entry in the tests), although products pass 2^53 from n = 52 on;
// beyond that each of the at most n/2 steps rounds twice. `binomial_roundings` counts them for the error bounds.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "core/curve.hpp"
#include "core/error_free.hpp"
#include "core/vector/shared.hpp"

namespace bezierbench {

/// A power of two that keeps C(n,i) (n - i + 1) finite: the recurrence runs on C(n,i) / binomial_scale(n).
constexpr double binomial_scale(int n) { return n > 1000 ? 0x1p+20 : 1; }

/// The row C(n,0..n), formed in double and rounded once to Scalar.
template <class Scalar, int Degree>
PerCoefficient<SharedBy<Scalar>, Degree> binomials(int n) {
  auto row = per_coefficient<SharedBy<Scalar>, Degree>(n);
  const double scale = binomial_scale(n);
  double value = 1 / scale;
  for (int i = 0; 2 * i <= n; ++i) {
    if (i > 0) value = value * (n - i + 1) / i;
    row[i] = static_cast<SharedBy<Scalar>>(value * scale);
    row[n - i] = row[i];
  }
  return row;
}

/// C(n, n/2), the largest C(n,i), to within n roundings.
constexpr double central_binomial(int n) {
  double value = 1;
  for (int i = 1; 2 * i <= n; ++i) value *= static_cast<double>(n - i + 1) / i;
  return value;
}

/// Largest n for which `binomials<double>` is exact.
inline constexpr int exact_binomial_degree = 54;

/// The largest number of roundings in any C(n,i): those of the recurrence, and the one to float.
constexpr double binomial_roundings(int n, double u) {
  return (n > exact_binomial_degree ? n : 0) + (u > 0x1p-53 ? 1 : 0);
}

namespace detail {

// Rows that are exact are tabulated at compile time, so that `prepare` has no division for each entry.

/// The number of entries of the rows before row n, one after the other.
constexpr std::size_t entries_before(int n) {
  return static_cast<std::size_t>(n) * (static_cast<std::size_t>(n) + 1) / 2;
}

template <class Scalar>
inline constexpr auto binomial_table = [] {
  std::array<Scalar, entries_before(exact_binomial_degree + 1)> table{};
  for (int n = 0; n <= exact_binomial_degree; ++n) {
    double value = 1;
    for (int i = 0; 2 * i <= n; ++i) {
      if (i > 0) value = value * (n - i + 1) / i;
      table[entries_before(n) + static_cast<std::size_t>(i)] = static_cast<Scalar>(value);
      table[entries_before(n) + static_cast<std::size_t>(n - i)] = static_cast<Scalar>(value);
    }
  }
  return table;
}();

}  // namespace detail

/// The values of `binomials<Scalar, Degree>(n)`, from the table where they are exact.
template <class Scalar, int Degree>
class BinomialRow {
 public:
  using Shared = SharedBy<Scalar>;

  explicit BinomialRow(int n) : first_(tabulated(n)) {
    if (first_ == nullptr) compute(n);
  }
  BinomialRow(const BinomialRow&) = delete;
  BinomialRow& operator=(const BinomialRow&) = delete;

  [[nodiscard]] const Shared& operator[](int i) const { return first_[i]; }

 private:
  static const Shared* tabulated(int n) {
    if constexpr (std::floating_point<Shared>)
      if (n <= exact_binomial_degree) return detail::binomial_table<Shared>.data() + detail::entries_before(n);
    return nullptr;
  }
  void compute(int n) {
    row_ = binomials<Scalar, Degree>(n);
    first_ = row_.data();
  }

  const Shared* first_;
  PerCoefficient<Shared, Degree> row_;
};

/// C(n,0..n) as unevaluated sums high + low.
template <class Scalar, int Degree>
struct BinomialPairs {
  PerCoefficient<SharedBy<Scalar>, Degree> high;
  PerCoefficient<SharedBy<Scalar>, Degree> low;
};

/// The row C(n,0..n), split into two Scalars: from the table where that is exact, else by the recurrence in
/// double-double.
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
