// SPDX-License-Identifier: MIT
// How cost grows with the degree: the exponent k of cost = c n^k, fitted, against the one that a method claims.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace bezierbench::metric {

struct Growth {
  double exponent;
  double low;  ///< end of the confidence interval of k, if residuals of logarithms are normal
  double high;
};

/// Least squares of log cost = log c + k log n: k = S_xy / S_xx, with the interval k +- t_(N-2) sqrt(S_rr / ((N-2)
/// S_xx)) of Student's t (Draper and Smith, Applied Regression Analysis, 3rd ed., section 1.4). A cost with a constant
/// part bends this line, which widens the interval. There are as many degrees as costs; pairs that are not positive and
/// finite are left out. Empty where fewer than three different degrees remain.
std::optional<Growth> growth(std::span<const double> degrees, std::span<const double> costs, double confidence);

enum class GrowthVerdict { within, above, unresolved };

constexpr std::string_view name(GrowthVerdict verdict) {
  switch (verdict) {
    case GrowthVerdict::within: return "within";
    case GrowthVerdict::above: return "above";
    case GrowthVerdict::unresolved: return "unresolved";
  }
  return "";
}

/// A tolerance between a claimed exponent and the next one. Processors raise the fitted exponent: with a short chain of
/// dependent steps they work on several independent points at once, and they lose this saving as n grows. A linear
/// method then reaches exponents of 1.3 over 3 <= n <= 30. This is a property of the processor, not a power of n.
inline constexpr double growth_margin = 0.5;

/// A claim O(n^k) is a bound from above, and terms of lower order make the fitted exponent smaller: `within` where the
/// whole interval lies below k + margin, `above` where it lies over it, else `unresolved`.
constexpr GrowthVerdict verdict(const Growth& fitted, int claimed, double margin = growth_margin) {
  if (fitted.high <= claimed + margin) return GrowthVerdict::within;
  if (fitted.low > claimed + margin) return GrowthVerdict::above;
  return GrowthVerdict::unresolved;
}

}  // namespace bezierbench::metric
