// SPDX-License-Identifier: MIT
// Rows of C(n,i) for reading: up to the degree to which they are exact from a table, which the compiler fills by the
// recurrence of binomial.hpp, so that `prepare` has no division for each of them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "core/basis/binomial.hpp"

namespace bezierbench {

namespace detail {

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

/// The values of `binomials<Scalar, Degree>(n)`.
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

}  // namespace bezierbench
