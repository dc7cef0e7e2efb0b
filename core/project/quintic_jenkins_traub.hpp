// SPDX-License-Identifier: MIT
// Formula: the roots of f = (C - P).C' / n in power form one after the other, each of what division by the former has
//   left. With H of degree m - 1, f' at first, and shifts s, where f and H mean their quotients by z - s,
//     H <- H(s) f - f(s) H,   s <- s - f(s) h / (f_m H(s)), h the leading coefficient of H:
//   five steps at s = 0; then steps at one s, as large as the smallest root can be, until the estimates of the root
//   settle; then s moves with each step until f(s) consists of rounding errors.
// Source: the document names this solver. The angles for s are 49 and 94 degrees. The coefficients are those of
//   quintic_companion.
// Cost: about ten steps for each root.
// Bound: polished_residual_bound of (C - P).C' at t inside (0, 1).
// Fails: as quintic_companion, whose rounded coefficients it shares. Quotients carry the errors of former roots, which
//   are those of the least size.
#pragma once

#include <optional>
#include <utility>

#include "core/project/complex_polynomial.hpp"
#include "core/project/quintic_companion.hpp"

namespace bezierbench {

struct QuinticJenkinsTraub : RootProjection<QuinticJenkinsTraub> {
  static constexpr MethodInfo info{.id = "quintic_jenkins_traub",
                                   .label = "Jenkins-Traub",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .max_degree = 20,
                                   .flops = "16 (2n-1) per step",
                                   .cost_exponent = 2,
                                   .citation = "[Jenkins and Traub 1970]; [Document 002], section 4"};
  static constexpr auto residual_bound = polished_residual_bound;

  template <int Dimension>
  static std::vector<double> coefficients(const OffsetCurve<Dimension>& offset) {
    return QuinticCompanion::coefficients(offset);
  }

  static RootCandidates roots(const std::vector<double>& coefficients) {
    if (coefficients.size() < 2) return {};
    std::vector<Complex> found;
    Complex direction(0.70710678118654752, -0.70710678118654752);
    for (ComplexPolynomial f(coefficients.begin(), coefficients.end()); f.size() > 1;) {
      const auto root = smallest_root(f, direction);
      if (!root) return {candidates_of(found), false};
      found.push_back(*root);
      f = divided(f, *root).quotient;
    }
    return {candidates_of(found), true};
  }

 private:
  static constexpr int shift_limit = 20;

  struct Division {
    ComplexPolynomial quotient;
    Complex rest;  ///< the value at the root
  };

  /// p by z - s.
  static Division divided(const ComplexPolynomial& p, const Complex& s) {
    Division result{ComplexPolynomial(p.size() - 1), p.back()};
    for (std::size_t j = p.size() - 1; j-- > 0;) {
      result.quotient[j] = result.rest;
      result.rest = product(result.rest, s) + p[j];
    }
    return result;
  }

  /// H over its largest coefficient, after a step at s.
  static ComplexPolynomial next(const ComplexPolynomial& h, const ComplexPolynomial& f, const Complex& s) {
    const auto [f_quotient, f_at_s] = divided(f, s);
    const auto [h_quotient, h_at_s] = divided(h, s);
    ComplexPolynomial result(h.size());
    double largest = 0;
    for (std::size_t j = 0; j < result.size(); ++j) {
      result[j] = product(h_at_s, f_quotient[j]);
      if (j < h_quotient.size()) result[j] -= product(f_at_s, h_quotient[j]);
      largest = std::max({largest, std::abs(result[j].real()), std::abs(result[j].imag())});
    }
    if (largest > 0)
      for (auto& coefficient : result) coefficient /= largest;
    return result;
  }

  /// The step from s to the estimate of the root; not a number where H(s) is 0.
  static Complex step_from(const Complex& s, const ComplexPolynomial& h, const ComplexPolynomial& f) {
    return -quotient(product(value_at(f, s).value, h.back()), product(f.back(), value_at(h, s).value));
  }

  /// The positive root of sum_(j >= 1) |f_j| x^j - |f_0|, no root of f is smaller; to a few per cent.
  static double smallest_size(const ComplexPolynomial& f) {
    const auto exceeds = [&](double x) {
      double sum = 0;
      for (std::size_t j = f.size() - 1; j > 0; --j) sum = (sum + magnitude(f[j])) * x;
      return sum > magnitude(f[0]);
    };
    double low = 1;
    while (low > 0 && exceeds(low)) low /= 2;
    while (std::isfinite(low) && !exceeds(2 * low)) low *= 2;
    double high = 2 * low;
    for (int k = 0; k < 6; ++k) {
      const double middle = (low + high) / 2;
      (exceeds(middle) ? high : low) = middle;
    }
    return low;
  }

  static std::optional<Complex> smallest_root(const ComplexPolynomial& f, Complex& direction) {
    if (f[0] == Complex()) return Complex();
    ComplexPolynomial h;
    for (std::size_t j = 1; j < f.size(); ++j) h.push_back(static_cast<double>(j) * f[j]);
    if (f.size() == 2) return -quotient(f[0], f[1]);
    for (int k = 0; k < 5; ++k) h = next(h, f, Complex());
    const double size = smallest_size(f);
    for (int shift = 1; shift <= shift_limit; ++shift) {
      direction = product(direction, Complex(-0.069756473744125301, 0.99756405025982425));  // by 94 degrees
      if (const auto root = root_by_shift(f, h, size * direction, 20 * shift)) return root;
    }
    return std::nullopt;
  }

  /// Both stages with shifts.
  static std::optional<Complex> root_by_shift(const ComplexPolynomial& f, ComplexPolynomial h, const Complex& s,
                                              int step_limit) {
    Complex before = step_from(s, h, f);
    int settled = 0;
    for (int k = 0; k < step_limit && settled < 2; ++k) {
      h = next(h, f, s);
      const Complex step = step_from(s, h, f);
      settled = magnitude(step - before) <= magnitude(s + before) / 2 ? settled + 1 : 0;
      before = step;
    }
    return settled == 2 ? root_by_moving(f, std::move(h), s + before) : std::nullopt;
  }

  static std::optional<Complex> root_by_moving(const ComplexPolynomial& f, ComplexPolynomial h, Complex s) {
    constexpr int step_limit = 30;
    for (int k = 0; k < step_limit; ++k) {
      if (value_at(f, s).is_rounding) return s;
      h = next(h, f, s);
      s += step_from(s, h, f);
    }
    return std::nullopt;
  }
};

}  // namespace bezierbench
