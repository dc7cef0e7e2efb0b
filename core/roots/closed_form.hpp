// SPDX-License-Identifier: MIT
// Formula: homogeneous in x = t and w = 1-t, so that the Bernstein coefficients are those of the polynomial and t = x /
//   (x + w), without cancellation where t is in [0, 1]; every difference of two products below has its roundings added.
//     line       b_0 w + b_1 x: (b_0 : -b_1)
//     quadratic  A x^2 + 2 B x w + C w^2, q = -(B + sign(B) sqrt(B^2 - A C)): (q : A) and (C : q)
//     cubic      A x^3 + 3 B x^2 w + 3 C x w^2 + D w^3, with the Hessian d_1 = A C - B^2, d_2 = A D - B C, d_3 = B D -
//                C^2 and D' = 4 d_1 d_3 - d_2^2. For D' < 0 one root, by cube roots; for D' > 0 the outer root next to
//                the axis of A and that of D, by cosines of thirds of angles, and the third by division; for D' = 0 the
//                double root (-d_2 : 2 d_1), too. A root at an end is divided out.
// Source: [Kahan 2004], the discriminant; [Blinn 2007], the cubic; the double root and the line are derived here.
// Cost: 6 for a line, about 60 and about 300, square roots and quotients among them. Thirds of angles and cube roots
//   are computed by Newton's method, so that no library decides their bits.
// Bound: none.
// Fails: a root outside [0, 1] by a rounding is lost; a double root of a cubic becomes two, one or none where the
//   roundings hide D' = 0.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/error_free.hpp"
#include "core/flatten/flattening.hpp"
#include "core/powers.hpp"
#include "core/roots/roots.hpp"

namespace bezierbench {

struct ClosedForm {
  static constexpr MethodInfo info{.id = "closed_form",
                                   .label = "Quadratic formula, Blinn's cubic",
                                   .problem = Problem::roots,
                                   .min_degree = 1,
                                   .max_degree = 3,
                                   .max_degree_float = 3,
                                   .flops = "6 to 300",
                                   .citation = "[Kahan 2004]; [Blinn 2007]"};

  static FoundRoots find(std::vector<double> b) {
    int exponent = -2000;
    for (const double x : b) exponent = x == 0 ? exponent : std::max(exponent, binary_exponent(x));
    for (double& x : b) x = std::ldexp(x, -exponent);  // products of six coefficients stay in range
    FoundRoots found;
    const auto take = [&](double x, double w) {
      const double t = x / (x + w);
      if (t >= 0 && t <= 1) found.t.push_back(t);  // never NaN
    };
    if (b.size() == 2) take(b[0], -b[1]);
    if (b.size() == 3) quadratic(b[2], b[1], b[0], take);
    if (b.size() == 4) cubic(b[3], b[2], b[1], b[0], take);
    std::ranges::sort(found.t);
    found.t.erase(std::unique(found.t.begin(), found.t.end()), found.t.end());
    return found;
  }

 private:
  /// a b - c d, with the roundings of both products where they cancel.
  static double difference_of_products(double a, double b, double c, double d) {
    const auto [p, of_p] = two_prod(a, b);
    const auto [q, of_q] = two_prod(c, d);
    if (3 * std::abs(p - q) >= std::abs(p) + std::abs(q)) return p - q;
    return (p - q) + (of_p - of_q);
  }

  template <class Take>
  static void quadratic(double a, double b, double c, const Take& take) {
    const double square = difference_of_products(b, b, a, c);
    if (square < 0) return;
    const double q = -(b + std::copysign(std::sqrt(square), b));
    take(q, a);
    if (square > 0) take(c, q);
  }

  struct Third {
    double cosine;
    double sine;
  };

  /// cos and sin of a third of the angle in [0, pi] of the point (x, y), y >= 0: the cube root z of x + i y on the unit
  /// circle by z -> (2 z + (x + i y) / z^2) / 3 from 30 degrees, which is within 30 degrees of it.
  static Third third_of_angle(double x, double y) {
    const double size = std::sqrt(x * x + y * y);
    const double along = x / size;
    const double across = y / size;
    double c = 0.8660254037844386;
    double s = 0.5;
    for (int step = 0; step < 8; ++step) {
      const double square = (c * c + s * s) * (c * c + s * s);
      const double re = (c * c - s * s) / square;  // of 1 / z^2
      const double im = -2 * c * s / square;
      const double next = (2 * c + (along * re - across * im)) / 3;
      s = (2 * s + (along * im + across * re)) / 3;
      c = next;
    }
    return {c, s};
  }

  template <class Take>
  static void cubic(double a, double b, double c, double d, const Take& take) {
    if (a == 0 || d == 0) {  // a root at an end; the others are those of a quadratic
      a == 0 ? take(1, 0) : take(0, 1);
      return a == 0 ? quadratic(6 * b, 3 * c, 2 * d, take) : quadratic(2 * a, 3 * b, 6 * c, take);
    }
    const double d1 = difference_of_products(a, c, b, b);
    const double d2 = difference_of_products(a, d, b, c);
    const double d3 = difference_of_products(b, d, c, c);
    const double discriminant = difference_of_products(4 * d1, d3, d2, d2);
    const double of_a = a * d2 - 2 * b * d1;  // D of the depressed cubic x^3 + 3 d1 x + of_a, scaled by a
    const double of_d = 2 * c * d3 - d * d2;  // likewise of the reversed one
    if (d1 == 0 && d2 == 0 && d3 == 0) return take(-b, a);
    if (discriminant <= 0) {
      const bool by_a = b * b * b * d >= a * c * c * c;
      const double leading = by_a ? a : d;
      const double linear = by_a ? d1 : d3;
      const double constant = by_a ? of_a : of_d;
      const double root = std::abs(leading) * std::sqrt(-discriminant);
      const double term = constant < 0 ? root : -root;
      const double sum = term - constant;
      const double p = std::copysign(cube_root(std::abs(sum / 2)), sum);
      const double q = sum == term ? -p : -linear / p;
      const double x = linear <= 0 ? p + q : -constant / (p * p + q * q + linear);
      by_a ? take(x - b, a) : take(-d, x + c);
      if (discriminant == 0) std::abs(d1) >= std::abs(d3) ? take(-d2, 2 * d1) : take(-2 * d3, d2);
      return;
    }
    const double root = std::sqrt(discriminant);
    constexpr double half_root_of_three = 0.8660254037844386;
    const auto outer = [&](double leading, double linear, double constant, auto is_first) {
      const auto [cosine, sine] = third_of_angle(-constant, std::abs(leading) * root);
      const double size = 2 * std::sqrt(-linear);
      const double first = size * cosine;
      const double last = size * (-cosine / 2 - half_root_of_three * sine);
      return is_first(first + last) ? first : last;
    };
    const double x_large = outer(a, d1, of_a, [&](double sum) { return sum > 2 * b; }) - b;
    const double w_small = outer(d, d3, of_d, [&](double sum) { return sum < 2 * c; }) + c;
    take(x_large, a);
    take(-d, w_small);
    const double e = a * w_small;
    const double f = a * d - x_large * w_small;
    const double g = -x_large * d;
    take(c * f - b * g, c * e - b * f);
  }
};

}  // namespace bezierbench
