// SPDX-License-Identifier: MIT
// A proved error bound of a derivative as data, like ErrorBound of a point.
//
// With D b_i = b_(i+1) - b_i, D^k the differences of the k-th order and (n)_k = n (n-1) ... (n-k+1), the k-th
// derivative has the Bernstein coefficients (n)_k D^k b_i, and two sums rule its error:
//   p~ = (n)_k sum_i |D^k b_i| B_i,n-k(t)                       scales the error of evaluating these coefficients
//   A  = (n)_k sum_i (sum_j C(k,j) |b_(i+j)|) B_i,n-k(t)        scales the error of forming the differences
// A / p~ is the condition number of the derivative: the factor by which it amplifies relative errors of the control
// points. The differences of points within a factor of two of each other are exact (Sterbenz), so a method that takes
// differences first can do far better than its bound. In power form the coefficients j (j-1) ... (j-k+1) q_j of t^(j-k)
// are formed without differences, and p~ is the sum of their magnitudes times |t|^(j-k).
//
// A rational curve with numerator A, denominator W and A_j, W_j, the sums A above of its control points w_i b_i and of
// its weights for order j, has
//   S_k = (A_k + sum_(i=1..k) C(k,i) W_i S_(k-i)) / |W(t)|,
// which is at least |C^(k)| and for k = 0 is p~. Where numerator and denominator of every order keep their bounds,
// u D_j times the A_j and W_j, the quotients keep
//   |computed - true| <= (k+1) s / (1 - (k+1) s) S_k,  s = G (1 + W_0 / |W(t)|) + gamma_(k+2) + u,
// where G is the largest u (D_j (1 + u) + 1), D_j = differences + evaluation, if (k+1) s < 1/2 (proof:
// docs/proofs/rational_derivative.md).
#pragma once

#include <string_view>

namespace bezierbench {

/// The bound on each axis, for a curve of degree n and a derivative of order k:
///   |computed - true| <= u (differences(n, k, u) A + evaluation(n, k, u) p~)
///                        + underflow(n, k) eta S (|t| + |1 - t|)^(n-k),
/// where eta is the smallest subnormal and S = 1 or, where powers of t are rounded apart from the coefficients,
/// S = 1 + (n)_k max_i sum_j C(k,j) |b_(i+j)|. Infinite where no bound is proved, so also where growth(n, k) S_0
/// (|t| + |1 - t|)^(n-k) leaves the range, with S_0 this maximum, or the largest coefficient of the derivative in power
/// form; where S is 1 + this maximum, S_0 is at least 1 (core/bound/error_bound.hpp).
struct DerivativeBound {
  std::string_view text;  ///< for people
  double (*differences)(int degree, int order, double u);
  double (*evaluation)(int degree, int order, double u);
  double (*underflow)(int degree, int order);
  bool underflow_scales_with_coefficients = false;
  double (*growth)(int degree, int order) = [](int, int) { return 1.0; };
};

}  // namespace bezierbench
