// SPDX-License-Identifier: MIT
// Formula: b_k = sum d_i N_i^k with N_i^0..N_i^n the Bernstein coefficients of N_i over the span. N_n^k = 0 for k < n,
//   N_i^n = N_i(c) by the recurrence of de Boor and Cox, N_0^0 = prod (c - a) / (c - u_j) over j = 0..n-2, else 0. For
//   i = n-1..1, with x = u_(i-1), y = u_(i+n+1), v = (u_(i+n) - x) / (y - u_i), k = n-1..0,
//     N_i^k = ((a - x) N_i^(k+1) + v ((c - y) N_(i+1)^k + (y - a) N_(i+1)^(k+1))) / (c - x).
//   Points by the triangle over b_k (`point_of_span`).
// Source: [Chudy and Wozny 2024] has the recurrence over one knot span, its order i = n..0, k = n..0 and its first
//   values N_n^n, N_i^n and N_0^0. Derived here from blossoms: let M be the basis function of degree n-1 over the knots
//   u_i..u_(i+n). The blossom f of N_i, with one argument x = u_(i-1), is (u_(i+n) - x) / (u_(i+n) - u_i) M; that of
//   N_(i+1), with one argument y, is (y - u_i) / (u_(i+n) - u_i) M. A blossom with one argument x has the Bernstein
//   coefficients ((c - x) f^k + (x - a) f^(k+1)) / (c - a). The coefficients of M follow from those of N_i and from
//   those of N_(i+1); set equal, they give the recurrence.
// Cost: for the control points about 11 n^2 + 2d n^2 flops, of which the first part does not depend on the curve.
// Bound: none. (c - y) is negative: the coefficients are positive, but come as differences of larger numbers, and an
//   error in one of them goes into all later ones.
// Fails: where these differences cancel. Clamped and uneven knots of degree 10 or more lose many digits. Differences of
//   knots may overflow.
#pragma once

#include "core/bspline/bspline.hpp"

namespace bezierbench {

struct ChudyWoznySpan {
  static constexpr MethodInfo info{.id = "chudy_wozny_span",
                                   .label = "Bernstein form by Chudy and Wozny",
                                   .problem = Problem::bspline,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .flops = "3d n(n+1)/2 + 5",
                                   .cost_exponent = 2,
                                   .prepare_exponent = 2,
                                   .citation = "[Chudy and Wozny 2024]"};

  template <class Scalar, int Dimension>
  static Curve<Form::bernstein, Scalar, Dimension> convert(const BsplineSpan<Scalar, Dimension>& span) {
    const int n = span.degree();
    const auto at_end = basis_functions(span, span.end());
    Curve<Form::bernstein, Scalar, Dimension> b(n);
    auto row = per_coefficient<Scalar, dynamic>(n);  // the coefficients of one N_i
    for (int k = 0; k <= n; ++k) row[k] = k < n ? Scalar(0) : at_end[n];
    for (int axis = 0; axis < Dimension; ++axis)
      for (int k = 0; k <= n; ++k) b(axis, k) = row[k] * span.control_points(axis, n);
    for (int i = n - 1; i > 0; --i) {
      step_to_the_left(span, i, at_end[i], row);
      add(span, i, row, 0, n, b);
    }
    row[0] = first_coefficient(span);
    add(span, 0, row, 0, 0, b);
    return b;
  }

 private:
  /// Turns the coefficients of N_(i+1) into those of N_i, whose last one is given.
  template <class Scalar, int Dimension>
  static void step_to_the_left(const BsplineSpan<Scalar, Dimension>& span, int i, const Scalar& last,
                               PerCoefficient<Scalar, dynamic>& row) {
    const int n = span.degree();
    const Scalar& a = span.begin();
    const Scalar& c = span.end();
    const Scalar& x = span.knot(i - 1);
    // N_n has one coefficient, from which y drops out: any knot behind a will do.
    const Scalar& y = span.knot(i + 1 < n ? i + n + 1 : i + n);
    const Scalar v = Scalar(span.knot(i + n) - x) / Scalar(y - span.knot(i));
    const Scalar from_x = a - x;
    const Scalar width = c - x;
    const Scalar behind_y = c - y;
    const Scalar to_y = y - a;
    Scalar following = row[n];  // N_(i+1)^(k+1)
    row[n] = last;
    for (int k = n - 1; k >= 0; --k) {
      const Scalar right_term = v * (behind_y * row[k] + to_y * following);
      following = row[k];
      row[k] = (from_x * row[k + 1] + right_term) / width;
    }
  }

  template <class Scalar, int Dimension>
  static Scalar first_coefficient(const BsplineSpan<Scalar, Dimension>& span) {
    Scalar product(1);
    for (int j = 0; j + 1 < span.degree(); ++j)
      product = product * (Scalar(span.end() - span.begin()) / Scalar(span.end() - span.knot(j)));
    return product;
  }

  /// Adds coefficients first..last of N_i, times d_i.
  template <class Scalar, int Dimension>
  static void add(const BsplineSpan<Scalar, Dimension>& span, int i, const PerCoefficient<Scalar, dynamic>& row,
                  int first, int last, Curve<Form::bernstein, Scalar, Dimension>& b) {
    for (int k = first; k <= last; ++k)
      for (int axis = 0; axis < Dimension; ++axis) b(axis, k) = b(axis, k) + row[k] * span.control_points(axis, i);
  }
};

}  // namespace bezierbench
