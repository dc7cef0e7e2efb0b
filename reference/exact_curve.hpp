// SPDX-License-Identifier: MIT
// The true point of a curve: control points and t are doubles, so it is a dyadic rational, computed in big integers.
//
// With t = T/2^k (T, k integers, k >= 0), S = 2^k - T, and coefficients B_i 2^e,
//   Bernstein form   p = 2^(e - kn) sum C(n,i) T^i S^(n-i) B_i
//   power form       p = 2^(e - kn) sum T^j 2^(k(n-j)) Q_j
//   centred form     as the power form, with T - 2^(k-1) for T
// which needs no fractions, and holds for every finite t: tiny, huge or negative. Double-double coefficients are the
// sums of their parts.
#pragma once

#include <vector>

#include "core/curve.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::reference {

/// Evaluates exactly; keeps its big integers between calls (so one object per thread).
class ExactCurve {
 public:
  /// The point of `curve` (finite coefficients, dimension at most 3) at finite t. Valid until the next call.
  const ExactPoint& point(const CurveView<double>& curve, double t);

  /// p~ = sum |c_i| |basis function i (t)| on each axis, over the coefficients in the form of `curve`, likewise.
  const ExactPoint& p_tilde(const CurveView<double>& curve, double t);

  /// What the Bernstein form gives when 1 - t is taken to be `complement`: sum b_i C(n,i) t^i complement^(n-i), divided
  /// by (t + complement)^n, which must not be 0, if `normalised`. Valid until the next call.
  const ExactPoint& with_complement(const CurveView<double>& curve, double t, double complement, bool normalised);

 private:
  void evaluate(const CurveView<double>& curve);
  void load(const CurveView<double>& curve, bool magnitudes);
  void set_parameter(double t, Form form, bool magnitudes);
  void set_complement(double complement);
  void sum_bernstein(int n, int dimension);
  void sum_power(int n, int dimension);

  ExactPoint point_;
  std::vector<mpz_class> coefficients_;  ///< point by point, times 2^coefficient_exponent_
  long coefficient_exponent_ = 0;
  mpz_class t_numerator_;             ///< T
  mpz_class one_minus_t_;             ///< S, over the same 2^k
  unsigned long t_shift_ = 0;         ///< k
  std::vector<mpz_class> binomials_;  ///< C(n, 0..n) of the last degree
  mpz_class t_power_;
  mpz_class weight_;
  mpz_class part_;
};

}  // namespace bezierbench::reference
