// SPDX-License-Identifier: MIT
// How cost grows with the degree: the exponent k of cost = c n^k, fitted, against the one that a method claims.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace bezierbench::metric {

struct Growth {
  double exponent;
  double low;  ///< of the interval that holds the exponent if the residuals of the logarithms are normal
  double high;
};

/// Least squares of log cost = log c + k log n: k = S_xy / S_xx, with the interval k +- t_(N-2) sqrt(S_rr / ((N-2)
/// S_xx)) of Student's t (Draper and Smith, Applied Regression Analysis, 3rd ed., section 1.4). A cost with a constant
/// part bends this line, which widens the interval. Degrees and costs are as many; those that are not positive and
/// finite are left out. Empty with fewer than three different degrees left.
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

/// Between a claim and the next power. Machines bend the line upwards too: the shorter a chain of dependent steps, the
/// more points are in flight at once, and what that saves is lost as n grows (a linear method reaches exponents of 1.3
/// over 3 <= n <= 30 where points are independent). That is a factor of the machine, not a power of n.
inline constexpr double growth_margin = 0.5;

/// A claim O(n^k) is a bound from above, and terms of lower order make the fitted exponent smaller: `within` where the
/// whole interval lies below k + margin, `above` where it lies over it, else `unresolved`.
constexpr GrowthVerdict verdict(const Growth& fitted, int claimed, double margin = growth_margin) {
  if (fitted.high <= claimed + margin) return GrowthVerdict::within;
  if (fitted.low > claimed + margin) return GrowthVerdict::above;
  return GrowthVerdict::unresolved;
}

}  // namespace bezierbench::metric
