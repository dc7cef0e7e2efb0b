// SPDX-License-Identifier: MIT
#include "reference/exact_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace bezierbench::reference {
namespace {

/// value = mantissa 2^exponent with an integer mantissa of at most 53 bits.
struct Split {
  std::int64_t mantissa;
  int exponent;
};
Split split(double value) {
  int exponent = 0;
  const double fraction = std::frexp(require_finite(value), &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

void next_binomials(int n, std::vector<mpz_class>& row) {
  if (row.size() == static_cast<std::size_t>(n) + 1) return;
  row.assign(static_cast<std::size_t>(n) + 1, 1);
  for (int i = 1; i <= n; ++i) {
    auto& entry = row[static_cast<std::size_t>(i)];
    entry = row[static_cast<std::size_t>(i) - 1] * (n - i + 1);
    entry /= i;
  }
}

/// The integers (values[k] + values[k + count] + ...) 2^-e for k < count; returns e.
long load_integers(std::span<const double> values, std::size_t count, std::vector<mpz_class>& integers) {
  integers.assign(count, 0);
  int lowest = std::numeric_limits<int>::max();
  for (const double value : values)
    if (value != 0) lowest = std::min(lowest, split(value).exponent);
  thread_local mpz_class part;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (values[k] == 0) continue;
    const auto [mantissa, exponent] = split(values[k]);
    mpz_set_si(part.get_mpz_t(), mantissa);
    part <<= static_cast<mp_bitcnt_t>(exponent - lowest);
    integers[k % count] += part;
  }
  return lowest == std::numeric_limits<int>::max() ? 0 : lowest;
}

}  // namespace

const ExactPoint& ExactCurve::point(const CurveView<double>& curve, double t) {
  load(curve, false);
  set_parameter(t, curve.form, false);
  sum(curve);
  if (curve.form == Form::rational) divide_by_weights(curve.degree);
  return point_;
}

const ExactPoint& ExactCurve::p_tilde(const CurveView<double>& curve, double t) {
  load(curve, true);
  set_parameter(t, curve.form, true);
  sum(curve);
  if (curve.form != Form::rational) return point_;
  set_parameter(t, curve.form, false);  // the sum of the weights keeps its signs
  divide_by_weights(curve.degree);
  for (auto& numerator : point_.numerator) numerator = ::abs(numerator);
  return point_;
}

const ExactPoint& ExactCurve::with_complement(const CurveView<double>& curve, double t, double complement,
                                              bool normalised) {
  load(curve, false);
  set_parameter(t, curve.form, false);
  set_complement(complement);
  sum(curve);
  if (curve.form == Form::rational) {
    divide_by_weights(curve.degree);
  } else if (normalised) {
    t_power_ = t_numerator_ + one_minus_t_;  // over 2^k, like both
    mpz_pow_ui(point_.denominator.get_mpz_t(), t_power_.get_mpz_t(), static_cast<unsigned long>(curve.degree));
    point_.exponent = coefficient_exponent_;
  }
  return point_;
}

const ExactPoint& ExactCurve::derivative(const CurveView<double>& curve, int order, double t) {
  if (curve.form == Form::rational) return quotient_derivative(curve, order, t, false);
  const auto derivative = load_derivative(curve, order);
  set_parameter(t, curve.form, false);
  sum(derivative);
  return point_;
}

const ExactPoint& ExactCurve::derivative_p_tilde(const CurveView<double>& curve, int order, double t) {
  if (curve.form == Form::rational) return quotient_derivative(curve, order, t, true);
  const auto derivative = load_derivative(curve, order);
  for (auto& coefficient : coefficients_) coefficient = ::abs(coefficient);
  set_parameter(t, curve.form, true);
  sum(derivative);
  return point_;
}

const ExactPoint& ExactCurve::quotient_derivative(const CurveView<double>& curve, int order, double t,
                                                  bool magnitudes) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  const auto orders = static_cast<std::size_t>(order) + 1;
  std::vector<mpz_class> a(orders * d);
  std::vector<mpz_class> w(orders);
  load(curve, magnitudes);
  set_parameter(t, Form::rational, false);
  if (magnitudes) {
    sum_bernstein(curve.degree, weights_, std::span(w).first(1));  // the denominator keeps its signs
    w[0] = ::abs(w[0]);
    for (auto& weight : weights_) weight = ::abs(weight);
    set_parameter(t, Form::rational, true);
  }
  const auto differentiate = [magnitudes](std::vector<mpz_class>& values, std::size_t step, int degree) {
    for (std::size_t i = 0; i + step < values.size(); ++i)
      values[i] =
          (magnitudes ? mpz_class(values[i + step] + values[i]) : mpz_class(values[i + step] - values[i])) * degree;
    values.resize(values.size() - step);
  };
  for (std::size_t k = 0; k < orders && k <= static_cast<std::size_t>(curve.degree); ++k) {
    const int degree = curve.degree - static_cast<int>(k);
    sum_bernstein(degree, coefficients_, std::span(a).subspan(k * d, d));
    if (k > 0 || !magnitudes) sum_bernstein(degree, weights_, std::span(w).subspan(k, 1));
    differentiate(coefficients_, d, degree);
    differentiate(weights_, 1, degree);
  }
  for (std::size_t k = 1; k < orders; ++k) {  // a becomes N
    for (std::size_t axis = 0; axis < d; ++axis) {
      mpz_class sum;
      mpz_class power = 1;  // W^(i-1)
      for (std::size_t i = 1; i <= k; ++i) {
        mpz_bin_uiui(weight_.get_mpz_t(), k, i);
        weight_ *= w[i] * power;
        mpz_addmul(sum.get_mpz_t(), weight_.get_mpz_t(), a[(k - i) * d + axis].get_mpz_t());
        power *= w[0];
      }
      auto& numerator = a[k * d + axis];
      numerator *= power;
      if (magnitudes)
        numerator += sum;
      else
        numerator -= sum;
    }
  }
  point_.dimension = curve.dimension;
  for (std::size_t axis = 0; axis < d; ++axis) point_.numerator[axis] = a[(orders - 1) * d + axis];
  mpz_pow_ui(point_.denominator.get_mpz_t(), w[0].get_mpz_t(), orders);
  point_.exponent = coefficient_exponent_ + static_cast<long>(t_shift_) * order;
  make_denominator_positive();
  return point_;
}

std::vector<double> ExactCurve::derivative_coefficients(const CurveView<double>& curve, int order) {
  load_derivative(curve, order);
  std::vector<double> rounded;
  for (const auto& coefficient : coefficients_)
    rounded.push_back(round_to(binary64, {coefficient, 1, coefficient_exponent_}));
  return rounded;
}

CurveView<double> ExactCurve::load_derivative(const CurveView<double>& curve, int order) {
  load(curve, false);
  const auto d = static_cast<std::size_t>(curve.dimension);
  for (int k = 0; k < std::min(order, curve.degree); ++k) {
    const auto remaining = static_cast<std::size_t>(curve.degree - k);  // the degree of what is differentiated
    for (std::size_t i = 0; i < remaining * d; ++i) {
      if (curve.form == Form::bernstein)
        coefficients_[i] = (coefficients_[i + d] - coefficients_[i]) * remaining;
      else
        coefficients_[i] = coefficients_[i + d] * (i / d + 1);
    }
    coefficients_.resize(remaining * d);
  }
  if (order > curve.degree) coefficients_.assign(d, 0);
  return {curve.form, curve.dimension, std::max(curve.degree - order, 0), {}};
}

void ExactCurve::load(const CurveView<double>& curve, bool magnitudes) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  const std::size_t count = static_cast<std::size_t>(curve.degree) + 1;
  // The low parts of double-double coefficients follow the high ones.
  coefficient_exponent_ = load_integers(curve.coefficients, count * d, coefficients_);
  if (curve.form == Form::rational) {
    load_integers(curve.weights, count, weights_);
    for (std::size_t k = 0; k < coefficients_.size(); ++k) coefficients_[k] *= weights_[k / d];
  }
  if (magnitudes)
    for (auto& coefficient : coefficients_) coefficient = ::abs(coefficient);
}

void ExactCurve::sum(const CurveView<double>& curve) {
  point_.dimension = curve.dimension;
  point_.denominator = 1;
  point_.exponent = coefficient_exponent_ - static_cast<long>(t_shift_) * curve.degree;
  if (curve.form == Form::bernstein || curve.form == Form::rational)
    sum_bernstein(curve.degree, coefficients_,
                  std::span(point_.numerator).first(static_cast<std::size_t>(curve.dimension)));
  else
    sum_power(curve.degree, curve.dimension);
}

/// The weights' powers of two are those of the numerators, too.
void ExactCurve::divide_by_weights(int n) {
  sum_bernstein(n, weights_, std::span(&point_.denominator, 1));
  point_.exponent = coefficient_exponent_;
  make_denominator_positive();
}

void ExactCurve::make_denominator_positive() {
  if (point_.denominator >= 0) return;
  point_.denominator = -point_.denominator;
  for (auto& numerator : point_.numerator) numerator = -numerator;
}

void ExactCurve::set_parameter(double t, Form form, bool magnitudes) {
  auto [mantissa, exponent] = split(t);
  if (t == 0) exponent = 0;
  while (exponent < 0 && mantissa != 0 && mantissa % 2 == 0) {
    mantissa /= 2;
    ++exponent;
  }
  mpz_set_si(t_numerator_.get_mpz_t(), mantissa);
  if (exponent > 0) t_numerator_ <<= static_cast<mp_bitcnt_t>(exponent);
  t_shift_ = exponent < 0 ? static_cast<unsigned long>(-exponent) : 0;
  if (form == Form::power_centered) {
    if (t_shift_ == 0) t_numerator_ <<= ++t_shift_;
    one_minus_t_ = 1;
    one_minus_t_ <<= t_shift_ - 1;
    t_numerator_ -= one_minus_t_;
  }
  one_minus_t_ = 1;
  one_minus_t_ <<= t_shift_;
  one_minus_t_ -= t_numerator_;
  if (magnitudes) {
    t_numerator_ = ::abs(t_numerator_);
    one_minus_t_ = ::abs(one_minus_t_);
  }
}

void ExactCurve::set_complement(double complement) {
  const auto [mantissa, exponent] = split(complement);
  const auto shift = exponent < 0 && mantissa != 0 ? static_cast<unsigned long>(-exponent) : 0;
  if (shift > t_shift_) {
    t_numerator_ <<= shift - t_shift_;
    t_shift_ = shift;
  }
  mpz_set_si(one_minus_t_.get_mpz_t(), mantissa);
  if (mantissa != 0) one_minus_t_ <<= static_cast<mp_bitcnt_t>(static_cast<long>(t_shift_) + exponent);
}

void ExactCurve::sum_bernstein(int n, const std::vector<mpz_class>& coefficients, std::span<mpz_class> sums) {
  next_binomials(n, binomials_);
  const std::size_t d = sums.size();
  for (std::size_t axis = 0; axis < d; ++axis) sums[axis] = coefficients[axis];
  t_power_ = 1;
  for (std::size_t i = 1; i <= static_cast<std::size_t>(n); ++i) {
    t_power_ *= t_numerator_;
    mpz_mul(weight_.get_mpz_t(), t_power_.get_mpz_t(), binomials_[i].get_mpz_t());
    for (std::size_t axis = 0; axis < d; ++axis) {
      mpz_ptr sum = sums[axis].get_mpz_t();
      mpz_mul(sum, sum, one_minus_t_.get_mpz_t());
      mpz_addmul(sum, weight_.get_mpz_t(), coefficients[i * d + axis].get_mpz_t());
    }
  }
}

void ExactCurve::sum_power(int n, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  const auto degree = static_cast<std::size_t>(n);
  for (std::size_t axis = 0; axis < d; ++axis) point_.numerator[axis] = coefficients_[degree * d + axis];
  for (std::size_t j = degree; j-- > 0;) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      mpz_ptr sum = point_.numerator[axis].get_mpz_t();
      mpz_mul(sum, sum, t_numerator_.get_mpz_t());
      mpz_mul_2exp(weight_.get_mpz_t(), coefficients_[j * d + axis].get_mpz_t(), t_shift_ * (degree - j));
      mpz_add(sum, sum, weight_.get_mpz_t());
    }
  }
}

namespace {

mpz_class binomial(int n, int k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

mpz_class factorial(int n) {
  mpz_class result;
  mpz_fac_ui(result.get_mpz_t(), static_cast<unsigned long>(n));
  return result;
}

/// The integer weight of coefficient k in coefficient m of the other form, over the common denominator.
mpz_class weight(Form from, int n, int m, int k) {
  if (from == Form::bernstein) return binomial(n, m) * binomial(m, k) * ((m - k) % 2 == 0 ? 1 : -1);
  return binomial(m, k) * factorial(k) * factorial(n - k);
}

}  // namespace

std::vector<ExactPoint> converted(const CurveView<double>& curve) {
  const int n = curve.degree;
  long lowest = std::numeric_limits<long>::max();
  for (const double value : curve.coefficients)
    if (value != 0) lowest = std::min(lowest, exactly(value).exponent);
  std::vector<ExactPoint> result(static_cast<std::size_t>(n) + 1);
  for (int m = 0; m <= n; ++m) {
    auto& point = result[static_cast<std::size_t>(m)];
    point.dimension = curve.dimension;
    point.denominator = curve.form == Form::bernstein ? mpz_class(1) : factorial(n);
    point.exponent = lowest == std::numeric_limits<long>::max() ? 0 : lowest;
    for (int k = 0; k <= m; ++k) {
      const mpz_class w = weight(curve.form, n, m, k);
      for (int axis = 0; axis < curve.dimension; ++axis) {
        if (curve(axis, k) == 0) continue;
        const Rational coefficient = exactly(curve(axis, k));
        const mpz_class aligned = coefficient.numerator << static_cast<mp_bitcnt_t>(coefficient.exponent - lowest);
        point.numerator[static_cast<std::size_t>(axis)] += w * aligned;
      }
    }
  }
  return result;
}

}  // namespace bezierbench::reference
