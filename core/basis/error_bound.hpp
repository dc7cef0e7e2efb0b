// SPDX-License-Identifier: MIT
// A proved error bound as data: one value per method, read by documentation, tests and the run-time check.
#pragma once

#include <limits>
#include <string_view>

namespace bezierbench {

/// The sum that a forward error bound multiplies; c are the given coefficients, x = |t|, y = |1 - t|.
/// Each is derived in core/basis/amplification.hpp.
enum class Amplification {
  p_tilde_bernstein,     ///< sum |c_i| C(n,i) x^i y^(n-i)
  p_tilde_power,         ///< sum |c_j| x^j
  bernstein_to_power,    ///< sum |c_i| C(n,i) x^i (1 + x)^(n-i), at most (1 + 2x)^n max|c|
  power_to_bernstein,    ///< sum |c_j| x^j (x + y)^(n-j), which is p~ for t in [0,1]
  forward_substitution,  ///< sum |c_j| x^j (3x + y)^(n-j): the signed solve amplifies like 3^n at t = 1
  p_tilde_centered,      ///< sum |c_j| |t - 1/2|^j
  bernstein_to_centered  ///< sum |c_i| C(n,i) (1/2 + |t - 1/2|)^n, at most (1 + 2|t - 1/2|)^n max|c|
};
inline constexpr int amplification_count = 7;

/// Proved bound on each axis:
///   |computed - true| <= result_roundings u |p| + factor(n, u) u A + underflow(n) eta S (x + y)^n,
/// where A is the amplification, eta the smallest subnormal, and S = 1 or, where powers of t are rounded apart from
/// the coefficients, S = 1 + max|c|. Holds while nothing overflows; infinite where no bound is proved. Whoever does not
/// know p takes |p| <= p~ of the given form, which is far below A on a converted path.
struct ErrorBound {
  std::string_view text;  ///< for people, e.g. "gamma_3n p~"
  Amplification amplification;
  double (*factor)(int degree, double u);  ///< u is the unit roundoff: 2^-53, or 2^-24 for float
  double (*underflow)(int degree);
  bool underflow_scales_with_coefficients;
  bool unit_interval_only = false;  ///< proved for 0 <= t <= 1 only
  double result_roundings = 0;      ///< roundings of the result itself: all that is left when the rest is compensated
};

/// gamma_k / u = k / (1 - k u): what k roundings can do to a product (Higham, Accuracy and Stability of Numerical
/// Algorithms, 2nd ed., Lemma 3.1), in units of u. Infinite where k u >= 1/2.
constexpr double gamma_over_u(double k, double u) {
  return k * u < 0.5 ? k / (1 - k * u) : std::numeric_limits<double>::infinity();
}

}  // namespace bezierbench
