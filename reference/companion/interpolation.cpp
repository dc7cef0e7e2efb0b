// SPDX-License-Identifier: MIT
#include "reference/companion/interpolation.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <utility>

namespace bezierbench::reference {
namespace {

/// The largest power of two, as exponent, of which all values are multiples.
long common_exponent(std::span<const double> values) {
  long exponent = 0;
  for (const double x : values)
    if (x != 0) exponent = std::min(exponent, exactly(x).exponent);
  return exponent;
}

/// The values over 2^exponent.
std::vector<mpz_class> integers(std::span<const double> values, long exponent) {
  std::vector<mpz_class> all;
  all.reserve(values.size());
  for (const double x : values) {
    const Rational exact = exactly(x);
    all.emplace_back(x == 0 ? mpz_class(0)
                            : mpz_class(exact.numerator << static_cast<mp_bitcnt_t>(exact.exponent - exponent)));
  }
  return all;
}

/// Keeps the largest magnitude.
void keep(mpz_class& largest, const mpz_class& value) {
  if (mpz_cmpabs(value.get_mpz_t(), largest.get_mpz_t()) > 0) largest = ::abs(value);
}

/// p + q a_0.
struct Shot {
  mpz_class p;
  mpz_class q;
};

/// The handles by the equations of all but the last row.
std::vector<Shot> shoot(const std::vector<mpz_class>& k) {
  const std::size_t n = k.size() - 1;
  std::vector<Shot> handles(n);
  handles[0].q = 1;
  if (n == 1) return handles;
  handles[1] = {k[0] + 2 * k[1], -2};
  for (std::size_t i = 1; i + 1 < n; ++i)
    handles[i + 1] = {4 * k[i] + 2 * k[i + 1] - handles[i - 1].p - 4 * handles[i].p,
                      -handles[i - 1].q - 4 * handles[i].q};
  return handles;
}

/// numerator / denominator = a_0 by the last row, or for a single segment by 3 a_0 = 2 K_0 + K_1; denominator > 0.
struct First {
  mpz_class numerator;
  mpz_class denominator;
};

First first_handle(const std::vector<mpz_class>& k, const std::vector<Shot>& handles) {
  const std::size_t n = handles.size();
  if (n == 1) return {2 * k[0] + k[1], 3};
  First first{8 * k[n - 1] + k[n] - 2 * handles[n - 2].p - 7 * handles[n - 1].p,
              2 * handles[n - 2].q + 7 * handles[n - 1].q};
  if (first.denominator < 0) first = {-first.numerator, -first.denominator};
  return first;
}

/// A linear equation for the inner control points: P1 and P2 of segment i are the unknowns 2i and 2i + 1.
struct Equation {
  std::vector<mpq_class> left;
  mpq_class right;
};

/// Adds equations in terms of control points, of which the outer ones are known.
class SplineEquations {
 public:
  explicit SplineEquations(std::span<const double> coordinates) : k_(coordinates.begin(), coordinates.end()) {}

  /// factor P_j,i is one term of the left-hand side.
  struct Term {
    mpq_class factor;
    std::size_t i;
    std::size_t j;
  };

  void add(const std::vector<Term>& terms, const mpq_class& right) {
    Equation equation{std::vector<mpq_class>(2 * (k_.size() - 1)), right};
    for (const auto& [factor, i, j] : terms) {
      if (j == 0 || j == 3)
        equation.right -= factor * k_[i + j / 3];
      else
        equation.left[2 * i + j - 1] += factor;
    }
    equations_.push_back(std::move(equation));
  }

  /// The difference of `order` of segment i, whose last control point has number `last`, times a factor.
  static std::vector<Term> difference(std::size_t order, std::size_t i, std::size_t last, const mpq_class& factor) {
    static constexpr int binomials[4][4]{{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    std::vector<Term> terms;
    for (std::size_t k = 0; k <= order; ++k)
      terms.push_back({factor * (k % 2 == 0 ? 1 : -1) * binomials[order][k], i, last - k});
    return terms;
  }

  /// The derivatives of `order` of two neighbouring segments, steps g and h, agree at their common knot.
  void join(std::size_t order, std::size_t before, const mpq_class& g, std::size_t after, const mpq_class& h) {
    mpq_class g_factor = 1;
    mpq_class h_factor = 1;
    for (std::size_t k = 0; k < order; ++k) {
      g_factor /= g;
      h_factor /= h;
    }
    auto terms = difference(order, before, 3, g_factor);
    const auto more = difference(order, after, order, -h_factor);
    terms.insert(terms.end(), more.begin(), more.end());
    add(terms, 0);
  }

  /// The solution of the equations, of which there are as many as unknowns.
  std::vector<mpq_class> solved() {
    const std::size_t count = equations_.size();
    for (std::size_t pivot = 0; pivot < count; ++pivot) {
      std::size_t row = pivot;
      while (equations_[row].left[pivot] == 0) ++row;
      std::swap(equations_[pivot], equations_[row]);
      const Equation& by = equations_[pivot];
      for (row = 0; row < count; ++row) {
        if (row == pivot || equations_[row].left[pivot] == 0) continue;
        const mpq_class factor = equations_[row].left[pivot] / by.left[pivot];
        for (std::size_t k = pivot; k < count; ++k) equations_[row].left[k] -= factor * by.left[k];
        equations_[row].right -= factor * by.right;
      }
    }
    std::vector<mpq_class> x;
    for (std::size_t k = 0; k < count; ++k) x.emplace_back(equations_[k].right / equations_[k].left[k]);
    return x;
  }

 private:
  std::vector<mpq_class> k_;
  std::vector<Equation> equations_;
};

void add_ends(const SplineSystem& system, SplineEquations& equations) {
  using Ends = SplineSystem::Ends;
  const auto h = [&](std::size_t i) { return mpq_class(system.steps[i]); };
  const std::size_t n = system.steps.size();
  const auto either = [&](std::size_t order, const mpq_class& start, const mpq_class& end) {
    equations.add(SplineEquations::difference(order, 0, order, 1), start);
    equations.add(SplineEquations::difference(order, n - 1, 3, 1), end);
  };
  if (system.ends == Ends::closed) {
    for (const std::size_t order : {1U, 2U}) equations.join(order, n - 1, h(n - 1), 0, h(0));
  } else if (system.ends == Ends::clamped) {
    either(1, mpq_class(system.start) / 3, mpq_class(system.end) / 3);
  } else if (system.ends == Ends::natural || n == 1) {
    either(2, 0, 0);
  } else if (n == 2) {
    either(3, 0, 0);
  } else {
    equations.join(3, 0, h(0), 1, h(1));
    equations.join(3, n - 2, h(n - 2), n - 1, h(n - 1));
  }
}

}  // namespace

ExactSpline exact_spline(std::span<const double> coordinates, const SplineSystem& system) {
  SplineEquations equations(coordinates);
  for (std::size_t i = 1; i < system.steps.size(); ++i)
    for (const std::size_t order : {1U, 2U})
      equations.join(order, i - 1, mpq_class(system.steps[i - 1]), i, mpq_class(system.steps[i]));
  add_ends(system, equations);
  const auto x = equations.solved();
  ExactSpline spline;
  for (std::size_t k = 0; k < x.size(); ++k)
    (k % 2 == 0 ? spline.first : spline.second).push_back({x[k].get_num(), x[k].get_den(), 0});
  return spline;
}

ExactSpline exact_spline(std::span<const double> coordinates) {
  const long exponent = common_exponent(coordinates);
  const auto k = integers(coordinates, exponent);
  const auto handles = shoot(k);
  const auto [numerator, denominator] = first_handle(k, handles);
  const std::size_t n = handles.size();
  ExactSpline spline;
  for (const Shot& handle : handles)
    spline.first.push_back({handle.p * denominator + handle.q * numerator, denominator, exponent});
  for (std::size_t i = 0; i + 1 < n; ++i)
    spline.second.push_back({2 * k[i + 1] * denominator - spline.first[i + 1].numerator, denominator, exponent});
  spline.second.push_back({k[n] * denominator + spline.first[n - 1].numerator, denominator, exponent - 1});
  return spline;
}

SplineResiduals spline_residuals(std::span<const double> coordinates, std::span<const double> segments) {
  const long exponent = std::min(common_exponent(coordinates), common_exponent(segments));
  const auto k = integers(coordinates, exponent);
  const auto p = integers(segments, exponent);
  const std::size_t n = k.size() - 1;
  mpz_class data;
  mpz_class c0;
  mpz_class c1;
  mpz_class c2;
  mpz_class natural;
  for (std::size_t i = 0; i < n; ++i) {
    const mpz_class* s = &p[4 * i];
    keep(data, s[0] - k[i]);
    keep(data, s[3] - k[i + 1]);
    if (i == 0) continue;
    const mpz_class* before = s - 4;
    keep(c0, s[0] - before[3]);
    keep(c1, (s[1] - s[0]) - (before[3] - before[2]));
    keep(c2, (s[0] - 2 * s[1] + s[2]) - (before[1] - 2 * before[2] + before[3]));
  }
  const mpz_class* last = &p[4 * (n - 1)];
  keep(natural, p[0] - 2 * p[1] + p[2]);
  keep(natural, last[1] - 2 * last[2] + last[3]);
  return {{data, 1, exponent}, {c0, 1, exponent}, {c1, 1, exponent}, {c2, 1, exponent}, {natural, 1, exponent}};
}

Rational inner_point_error(const ExactSpline& exact, std::span<const double> segments) {
  Rational largest;
  const auto keep_error = [&](double value, const Rational& truth) {
    const Rational error = abs(exactly(value) - truth);
    if ((error - largest).numerator > 0) largest = error;
  };
  for (std::size_t i = 0; i < exact.first.size(); ++i) {
    keep_error(segments[4 * i + 1], exact.first[i]);
    keep_error(segments[4 * i + 2], exact.second[i]);
  }
  return largest;
}

}  // namespace bezierbench::reference
