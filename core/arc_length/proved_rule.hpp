// SPDX-License-Identifier: MIT
// The Gauss-Legendre rule with the fewest points that the Chebyshev series of h proves to miss no more than is allowed
// of the mean speed |h| on [-1, 1].
//
// Theory: the error of N points for a function that is analytic in an ellipse ([Trefethen 2013], theorem 19.3);
//   docs/proofs/proved_rule.md shows that |h| is, where the first coefficient exceeds the others there.
// Cost: one ellipse per rule, just large enough for the error that is allowed.
// Bound: the constants are rounded up by a few u, which cover the roundings of the bound itself.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/arc_length/chebyshev_series.hpp"
#include "core/powers.hpp"

namespace bezierbench {

/// A rule of 8, 16 or 24 points; 0 points if none is proved.
struct ProvedRule {
  int points = 0;
  double missed = 0;  ///< largest error of the mean speed
};

namespace detail {

inline constexpr std::size_t gauss_rules = 3;
inline constexpr std::size_t ellipse_count = 64;

/// Ellipses with rho = 2^(1/16), 2^(2/16) ... 16.
struct Ellipses {
  std::array<double, ellipse_count> half_axis;                        ///< (rho + 1/rho)/2 = A_1
  std::array<std::array<double, ellipse_count>, gauss_rules> missed;  ///< largest error of each rule, for M = 1
};

inline constexpr Ellipses ellipses = [] {
  Ellipses table{};
  double rho = 1;
  for (std::size_t i = 0; i < ellipse_count; ++i) {
    rho *= 1.0442737824274138;
    table.half_axis[i] = (rho + 1 / rho) / 2;
    const double by_eight_points = integer_power(1 / rho, 16);
    double missed = 32.0 / 15 * (1 + 0x1p-20) / (1 - 1 / (rho * rho));
    for (auto& row : table.missed) row[i] = missed *= by_eight_points;
  }
  return table;
}();

/// The index of the smallest ellipse with which the rule of 8 `eights` points misses at most 2^-exponent M: rho^(-16
/// eights) <= 2^-(exponent + 3). The factor before rho^(-2N) in the theorem is at most 8 from rho = 1.2 on.
constexpr std::size_t ellipse_for(int exponent, int eights) {
  return static_cast<std::size_t>(std::max((exponent + 2) / eights, 0));
}

}  // namespace detail

/// The rule that is proved for the mean speed on [-1, 1]. `allowed` is absolute; the part cut from the series counts
/// twice.
template <int Dimension>
ProvedRule proved_rule(const ChebyshevSeries<Dimension>& h, double allowed) {
  using detail::ellipses;
  using Lanes [[gnu::vector_size(4 * sizeof(double))]] = double;  // one for each rule, and one that is not used
  const double allowed_of_rule = allowed - 2 * h.cut();
  const double limit = h.size(0) * (1 - 0x1p-20);
  const double largest = 2 * h.size(0);
  if (!(allowed_of_rule > 0 && limit > 0)) return {};
  if (h.degree() == 0) return {8, 2 * h.cut()};  // a constant, of which a rule misses nothing
  const int exponent = binary_exponent(largest / allowed_of_rule);
  const auto last = detail::ellipse_count - 1;
  const std::array<std::size_t, detail::gauss_rules> ellipse{std::min(detail::ellipse_for(exponent, 1), last),
                                                             std::min(detail::ellipse_for(exponent, 2), last),
                                                             std::min(detail::ellipse_for(exponent, 3), last)};
  const Lanes half_axis{ellipses.half_axis[ellipse[0]], ellipses.half_axis[ellipse[1]], ellipses.half_axis[ellipse[2]]};
  const Lanes twice = 2 * half_axis;
  Lanes before{1, 1, 1};
  Lanes here = half_axis;
  Lanes sum{};
  for (std::size_t k = 1; k <= h.degree(); ++k) {
    sum += h.size(k) * here;
    const Lanes after = twice * here - before;  // A_(k+1) = T_(k+1)(A_1)
    before = here;
    here = after;
  }
  for (std::size_t r = 0; r < detail::gauss_rules; ++r) {
    const double missed = largest * ellipses.missed[r][ellipse[r]];
    if (sum[r] <= limit && missed <= allowed_of_rule) return {8 * static_cast<int>(r + 1), missed + 2 * h.cut()};
  }
  return {};
}

}  // namespace bezierbench
