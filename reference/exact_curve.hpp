// SPDX-License-Identifier: MIT
// The true point of a curve: control points, weights and t are doubles, so it is a rational number (dyadic, except for
// rational curves), computed in big integers.
//
// With t = T/2^k (T, k integers, k >= 0), S = 2^k - T, and coefficients B_i 2^e,
//   Bernstein form   p = 2^(e - kn) sum C(n,i) T^i S^(n-i) B_i
//   power form       p = 2^(e - kn) sum T^j 2^(k(n-j)) Q_j
//   centred form     as the power form, with T - 2^(k-1) for T
//   rational         p = 2^e sum C(n,i) T^i S^(n-i) W_i B_i / sum C(n,i) T^i S^(n-i) W_i
// and of the k-th derivative of the first two, likewise with degree n - k, the coefficients
//   Bernstein form   n (n-1) ... (n-k+1) D^k B_i, D B_i = B_(i+1) - B_i
//   power form       (j+k) (j+k-1) ... (j+1) Q_(j+k)
// which needs no fractions, and holds for every finite t: tiny, huge or negative. Double-double coefficients are the
// sums of their parts. With A^(k) and W^(k) for those of numerator and denominator, of degree n - k each, a rational
// curve has C^(k) = N_k / W^(k+1), N_k = A^(k) W^k - sum_(i=1..k) C(k,i) W^(i) W^(i-1) N_(k-i), by induction from
// A^(k) = sum C(k,i) W^(i) C^(k-i). Over 2^(e + shift k) all powers of two cancel.
#pragma once

#include <span>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::reference {

/// Evaluates exactly; keeps its big integers between calls (so one object per thread).
class ExactCurve {
 public:
  /// The point of `curve` (finite coefficients and weights, dimension at most 3) at finite t. A rational curve has none
  /// where sum w_i B_i(t) = 0. Valid until the next call.
  const ExactPoint& point(const CurveView<double>& curve, double t);

  /// p~ = sum |c_i| |basis function i (t)| on each axis, over the coefficients in the form of `curve`; for a rational
  /// curve sum |w_i b_i| |B_i(t)| / |sum w_i B_i(t)|, likewise.
  const ExactPoint& p_tilde(const CurveView<double>& curve, double t);

  /// The Bernstein form with `complement` in place of 1 - t: sum b_i C(n,i) t^i complement^(n-i); if `normalised`,
  /// divided by (t + complement)^n, which must not be 0. For a rational curve this division changes nothing, because
  /// the weights are summed with the same complement. Valid until the next call.
  const ExactPoint& with_complement(const CurveView<double>& curve, double t, double complement, bool normalised);

  /// The derivative of this order >= 0 of a curve in Bernstein, power or rational form. Valid until the next call.
  const ExactPoint& derivative(const CurveView<double>& curve, int order, double t);

  /// p~ of that derivative, over its own coefficients in the form of `curve`; for a rational curve S_k of
  /// core/bound/derivative_bound.hpp, likewise on each axis. Valid until the next call.
  const ExactPoint& derivative_p_tilde(const CurveView<double>& curve, int order, double t);

  /// The coefficients of that derivative in the form of `curve`, point by point, each rounded once (infinite where it
  /// overflows); the single point 0 for orders beyond the degree.
  std::vector<double> derivative_coefficients(const CurveView<double>& curve, int order);

 private:
  void load(const CurveView<double>& curve, bool magnitudes);
  /// Loads the coefficients of the derivative; returns a curve of its form, dimension and degree, without coefficients.
  CurveView<double> load_derivative(const CurveView<double>& curve, int order);
  void sum(const CurveView<double>& curve);
  /// C^(k) of a rational curve or, if `magnitudes`, S_k.
  const ExactPoint& quotient_derivative(const CurveView<double>& curve, int order, double t, bool magnitudes);
  void divide_by_weights(int n);
  void make_denominator_positive();
  void set_parameter(double t, Form form, bool magnitudes);
  void set_complement(double complement);
  void sum_bernstein(int n, const std::vector<mpz_class>& coefficients, std::span<mpz_class> sums);
  void sum_power(int n, int dimension);

  ExactPoint point_;
  std::vector<mpz_class> coefficients_;  ///< point by point, times 2^coefficient_exponent_
  long coefficient_exponent_ = 0;
  std::vector<mpz_class> weights_;    ///< weights of a rational curve, times a power of two
  mpz_class t_numerator_;             ///< T
  mpz_class one_minus_t_;             ///< S, over the same 2^k
  unsigned long t_shift_ = 0;         ///< k
  std::vector<mpz_class> binomials_;  ///< C(n, 0..n) of the last degree
  mpz_class t_power_;
  mpz_class weight_;
};

// The true coefficients of a curve in the other form.

/// Coefficients of `curve` in the other form, each a point:
///   q_j = C(n,j) sum_i (-1)^(j-i) C(j,i) b_i,    b_i = sum_(j<=i) C(i,j) / C(n,j) q_j (over the denominator n!).
std::vector<ExactPoint> converted(const CurveView<double>& curve);

}  // namespace bezierbench::reference
