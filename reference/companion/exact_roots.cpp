// SPDX-License-Identifier: MIT
#include "reference/companion/exact_roots.hpp"

#include <algorithm>

#include "reference/companion/integer_polynomial.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {
namespace {

Rational weight(const CurveView<double>& curve, int i) {
  return exactly(curve.form == Form::rational ? curve.weights[static_cast<std::size_t>(i)] : 1);
}

/// The polynomial, over a power of two, with these coefficients in the form of the curve.
IntegerPolynomial polynomial(Form form, const std::vector<Rational>& coefficients) {
  long exponent = 0;
  if (form != Form::power) return from_bernstein(coefficients, exponent);
  exponent = std::ranges::min(coefficients, {}, &Rational::exponent).exponent;
  IntegerPolynomial p;
  for (const auto& c : coefficients) p.emplace_back(c.numerator << static_cast<mp_bitcnt_t>(c.exponent - exponent));
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

IntegerPolynomial numerator(const CurveView<double>& curve, int axis) {
  std::vector<Rational> coefficients;
  for (int i = 0; i <= curve.degree; ++i) coefficients.push_back(exactly(curve(axis, i)) * weight(curve, i));
  return polynomial(curve.form, coefficients);
}

IntegerPolynomial denominator(const CurveView<double>& curve) {
  if (curve.form != Form::rational) return {1};
  std::vector<Rational> coefficients;
  for (int i = 0; i <= curve.degree; ++i) coefficients.push_back(weight(curve, i));
  return polynomial(curve.form, coefficients);
}

/// A root of a square-free factor; factors have no root in common.
struct FactorRoot {
  const IntegerPolynomial* factor;
  RootInterval root;
  int multiplicity;
};

constexpr unsigned long first_bits = 64;

/// The root rounded to double: narrows its interval until both ends round to the same number.
double rounded(FactorRoot& found) {
  auto& root = found.root;
  for (unsigned long bits = first_bits;; bits *= 2) {
    refine(*found.factor, root, bits);
    const auto exponent = -static_cast<long>(root.t.shift);
    const double low = round_to(binary64, {root.t.k, 1, exponent});
    if (root.exact || low == round_to(binary64, {root.t.k + 1, 1, exponent})) return low;
  }
}

/// Whether a is left of b, which is another root; narrows both until their intervals are apart.
bool is_before(FactorRoot& a, FactorRoot& b) {
  const auto end = [](const FactorRoot& found) { return found.root.t.k + (found.root.exact ? 0 : 1); };
  const auto not_after = [](const mpz_class& x, const Dyadic& of_x, const mpz_class& y, const Dyadic& of_y) {
    return mpz_class(x << of_y.shift) <= mpz_class(y << of_x.shift);
  };
  for (unsigned long bits = first_bits;; bits *= 2) {
    if (not_after(end(a), a.root.t, b.root.t.k, b.root.t)) return true;
    if (not_after(end(b), b.root.t, a.root.t.k, a.root.t)) return false;
    refine(*a.factor, a.root, bits);
    refine(*b.factor, b.root, bits);
  }
}

Roots roots_of(const IntegerPolynomial& p) {
  if (p.empty()) return {.everywhere = true, .roots = {}};
  const auto factors = square_free_factors(p);
  std::vector<FactorRoot> all;
  for (std::size_t k = 0; k < factors.size(); ++k)
    for (const auto& root : isolate_roots(factors[k])) all.push_back({&factors[k], root, static_cast<int>(k) + 1});
  std::vector<FactorRoot*> ascending;
  for (auto& root : all)
    ascending.insert(std::ranges::find_if(ascending, [&](auto* other) { return is_before(root, *other); }), &root);
  Roots found;
  for (auto* root : ascending) found.roots.push_back({rounded(*root), root->multiplicity});
  return found;
}

}  // namespace

Roots roots_of_value(const CurveView<double>& curve, int axis, double value) {
  std::vector<Rational> coefficients;
  for (int i = 0; i <= curve.degree; ++i) {
    const bool moves = curve.form != Form::power || i == 0;
    const auto moved = moves ? exactly(curve(axis, i)) - exactly(value) : exactly(curve(axis, i));
    coefficients.push_back(moved * weight(curve, i));
  }
  return roots_of(polynomial(curve.form, coefficients));
}

Roots roots_of_derivative(const CurveView<double>& curve, int axis) {
  const auto n = numerator(curve, axis);
  const auto w = denominator(curve);
  return roots_of(difference(product(derivative(n), w), product(n, derivative(w))));
}

Roots roots_of_curvature(const CurveView<double>& curve) {
  const IntegerPolynomial rows[] = {numerator(curve, 0), numerator(curve, 1), denominator(curve)};
  IntegerPolynomial determinant;
  for (int k = 0; k < 3; ++k) {  // along the column P
    const auto first = derivative(rows[(k + 1) % 3]);
    const auto second = derivative(rows[(k + 2) % 3]);
    const auto minor = difference(product(derivative(first), second), product(first, derivative(second)));
    determinant = difference(determinant, product(rows[k], minor));
  }
  return roots_of(determinant);
}

}  // namespace bezierbench::reference
