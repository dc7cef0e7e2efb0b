// SPDX-License-Identifier: MIT
#include "reference/exact_conversion.hpp"

#include <algorithm>
#include <limits>

namespace bezierbench::reference {
namespace {

mpz_class binomial(int n, int k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

mpz_class factorial(int n) {
  mpz_class result;
  mpz_fac_ui(result.get_mpz_t(), static_cast<unsigned long>(n));
  return result;
}

/// The integer weight of coefficient k in coefficient m of the other form, over the common denominator.
mpz_class weight(Form from, int n, int m, int k) {
  if (from == Form::bernstein) return binomial(n, m) * binomial(m, k) * ((m - k) % 2 == 0 ? 1 : -1);
  return binomial(m, k) * factorial(k) * factorial(n - k);
}

}  // namespace

std::vector<ExactPoint> converted(const CurveView<double>& curve) {
  const int n = curve.degree;
  long lowest = std::numeric_limits<long>::max();
  for (const double value : curve.coefficients)
    if (value != 0) lowest = std::min(lowest, exactly(value).exponent);
  std::vector<ExactPoint> result(static_cast<std::size_t>(n) + 1);
  for (int m = 0; m <= n; ++m) {
    auto& point = result[static_cast<std::size_t>(m)];
    point.dimension = curve.dimension;
    point.denominator = curve.form == Form::bernstein ? mpz_class(1) : factorial(n);
    point.exponent = lowest == std::numeric_limits<long>::max() ? 0 : lowest;
    for (int k = 0; k <= m; ++k) {
      const mpz_class w = weight(curve.form, n, m, k);
      for (int axis = 0; axis < curve.dimension; ++axis) {
        if (curve(axis, k) == 0) continue;
        const Rational coefficient = exactly(curve(axis, k));
        const mpz_class aligned = coefficient.numerator << static_cast<mp_bitcnt_t>(coefficient.exponent - lowest);
        point.numerator[static_cast<std::size_t>(axis)] += w * aligned;
      }
    }
  }
  return result;
}

}  // namespace bezierbench::reference
