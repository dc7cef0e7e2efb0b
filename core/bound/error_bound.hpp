// SPDX-License-Identifier: MIT
// A proved error bound as data: one value per method, read by documentation, tests and the run-time check.
#pragma once

#include <limits>
#include <string_view>

namespace bezierbench {

/// The sum that a forward error bound multiplies; c are the given coefficients, x = |t|, y = |1 - t|. d are the
/// differences of control points from the end that t is nearer to, from b_0 for t <= 1/2, and z = min(x, y).
/// Each is derived in core/bound/amplification.hpp.
enum class Amplification {
  p_tilde_bernstein,          ///< sum |c_i| C(n,i) x^i y^(n-i)
  p_tilde_power,              ///< sum |c_j| x^j
  bernstein_to_power,         ///< sum |c_i| C(n,i) x^i (1 + x)^(n-i), at most (1 + 2x)^n max|c|
  power_to_bernstein,         ///< sum |c_j| x^j (x + y)^(n-j), which is p~ for t in [0,1]
  forward_substitution,       ///< sum |c_j| x^j (3x + y)^(n-j): the signed solve amplifies like 3^n at t = 1
  p_tilde_centered,           ///< sum |c_j| |t - 1/2|^j
  bernstein_to_centered,      ///< sum |c_i| C(n,i) (1/2 + |t - 1/2|)^n, at most (1 + 2|t - 1/2|)^n max|c|
  spread,                     ///< sum |d_i| C(n,i) x^i y^(n-i)
  spread_to_power,            ///< sum |d_i| C(n,i) z^i (1 + z)^(n-i), with d_i counted from the nearer end
  spread_to_power_from_start  ///< sum |c_i - c_0| C(n,i) x^i (1 + x)^(n-i)
};
inline constexpr int amplification_count = 10;

/// The control point that a sum counts magnitudes from: none, b_0, or the end that t is nearer to.
enum class Anchor { none, start, nearer_end };

constexpr Anchor anchor_of(Amplification kind) {
  switch (kind) {
    case Amplification::spread:
    case Amplification::spread_to_power: return Anchor::nearer_end;
    case Amplification::spread_to_power_from_start: return Anchor::start;
    default: return Anchor::none;
  }
}

/// Proved bound on each axis:
///   |computed - true| <= result_roundings u |p| + factor(n, u) u A + underflow(n) eta S (x + y)^n,
/// where A is the amplification, eta the smallest subnormal, and S = 1 or, where powers of t are rounded apart from
/// the coefficients, S = 1 + max|c|. Infinite where no bound is proved, so also where a result on the way may overflow:
/// proved while growth(n) S_0 (x + y)^n stays in range (`stays_in_range`), with S_0 = max|c| or, as above,
/// max(1, max|c|). A caller that does not know p takes |p| <= p~ of the given form, which is far below A on a converted
/// path.
///
/// For a rational curve with weights >= 0 and W = sum w_i B_i(t) > 0, for 0 <= t <= 1 only,
///   |computed - true| <= factor(n, u) u p~ + eta + underflow(n) eta (S + S_W p~) / W
/// with S = S_W = 1 or, as above, S = 1 + max|w_i b_i| and S_W = 1 + max w_i; proved while underflow(n) eta S_W / W is
/// at most 1/8, with max(|w_i b_i|, 2 |b_i|, w_i) for max|c| in S_0. A method that divides by weights needs positive
/// ones; then
///   |computed - true| <= factor(n, u) u p~ + eta + underflow(n) eta (1 + max|b_i|) (1 + max w_i) / min w_i
/// while 2^n (n + 1) (1 + max w_i) (1 + 1/min w_i) is in range.
struct ErrorBound {
  std::string_view text;  ///< for people, e.g. "gamma_3n p~"
  Amplification amplification;
  double (*factor)(int degree, double u);  ///< u is the unit roundoff: 2^-53, or 2^-24 for float
  double (*underflow)(int degree);
  bool underflow_scales_with_coefficients = false;
  /// No result of an operation is larger than growth S_0 (x + y)^n, except for the roundings before it, which are
  /// at most 5 (n + 1)^2. Binomials and factorials stay in range by the degrees that the method declares.
  double (*growth)(int degree) = [](int) { return 1.0; };
  bool unit_interval_only = false;     ///< proved for 0 <= t <= 1 only
  bool positive_weights_only = false;  ///< of a rational method: weights of 0 are not allowed
  double result_roundings = 0;  ///< roundings of the result itself: all that is left when the rest is compensated
  /// Of a method that chooses by axis: the bound where the curve is local (core/bound/locality.hpp). All else here is
  /// of the other axes.
  const ErrorBound* of_local = nullptr;
  /// Another bound of the method, which holds as well and is far lower where all control points are near b_0.
  const ErrorBound* also = nullptr;
  /// Of a method for power form that adds c_0 last, so that it rounds c_0 in the result only: also
  ///   |computed - true| <= constant_roundings u |p| + factor(n, u) u sum_(j>0) |c_j| x^j
  ///                        + underflow(n) eta S (x + y)^n.
  /// 0 of all other methods.
  double constant_roundings = 0;
};

/// gamma_k / u = k / (1 - k u): how much k roundings can change a product ([Higham 2002], Lemma 3.1), in units of u.
/// Infinite where k u >= 1/2.
constexpr double gamma_over_u(double k, double u) {
  return k * u < 0.5 ? k / (1 - k * u) : std::numeric_limits<double>::infinity();
}

/// Whether results of a method of this degree stay in range if, except for at most 5 (n + 1)^2 roundings, none is
/// larger than `largest`: with k roundings a result is below (1 + 2 k u) times as large.
constexpr bool stays_in_range(double largest, int degree, double u) {
  const double most = u > 0x1p-53 ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max();
  return largest * (1 + 10.0 * (degree + 1) * (degree + 1) * u) <= most;
}

}  // namespace bezierbench
