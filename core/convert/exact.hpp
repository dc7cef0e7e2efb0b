// SPDX-License-Identifier: MIT
// Formula: conversions in exact integer arithmetic, every coefficient rounded once, correctly.
//   To power form: q_j = C(n,j) D^j b_0 = C(n,j) sum_i (-1)^(j-i) C(j,i) b_i, a dyadic rational.
//   To power form in double-double: the same q_j, rounded, and the remainder, rounded.
//   To power form about t = 1/2: q_j = C(n,j) 2^(j-n) sum_i C(n-j,i) D^j b_i, a dyadic rational.
//   To Bernstein form: b_i = (1/n!) sum_j C(i,j) j! (n-j)! q_j, a rational with denominator n!.
// Cost: n^2/2 operations on big integers, each far dearer than a flop of the other conversions. On integers of O(n)
//   bits that is O(n^3) to power form, by sums, and O(n^4) about t = 1/2, by products. To Bernstein form n! has
//   O(n log n) bits, so that the n products with j! (n-j)! take O(n^3 log^2 n); the sums take less.
// Bound: u |coefficient|, one rounding each; u^2 |coefficient| in double-double.
// Fails: only where the rounded coefficient overflows, so power form ends at degree 640 (76 in float). But a correctly
//   rounded power coefficient already carries the error that ruins power form at high degree.
#pragma once

#include <span>
#include <vector>

#include "core/convert/conversion.hpp"

namespace bezierbench {

/// Rounds into the precision and range of this type (values are handed over as double, which holds any float).
enum class RoundTo { binary32, binary64 };

/// One axis: `in` and `out` hold the n + 1 coefficients, ascending; all inputs finite. Nearest, ties to even.
void exact_to_power(std::span<const double> in, std::span<double> out, RoundTo target);
void exact_to_bernstein(std::span<const double> in, std::span<double> out, RoundTo target);
void exact_to_power_centered(std::span<const double> in, std::span<double> out, RoundTo target);
/// Where `high` overflows, `low` is 0.
void exact_to_power_double_double(std::span<const double> in, std::span<double> high, std::span<double> low,
                                  RoundTo target);

namespace detail {

template <Form To, Form From, class Scalar, int Dimension, int Degree, class Exact>
Curve<To, Scalar, Dimension, Degree> convert_axes(const Curve<From, Scalar, Dimension, Degree>& curve, Exact exact) {
  constexpr RoundTo target = sizeof(Scalar) == sizeof(float) ? RoundTo::binary32 : RoundTo::binary64;
  const int n = curve.degree();
  std::vector<double> in(static_cast<std::size_t>(n) + 1);
  std::vector<double> out(in.size());
  const auto copy = [&](const std::vector<double>& row, auto& part, int axis) {
    for (int i = 0; i <= n; ++i) part(axis, i) = static_cast<Scalar>(row[static_cast<std::size_t>(i)]);
  };
  Curve<To, Scalar, Dimension, Degree> result(n);
  for (int axis = 0; axis < Dimension; ++axis) {
    for (int i = 0; i <= n; ++i) in[static_cast<std::size_t>(i)] = static_cast<double>(curve(axis, i));
    if constexpr (To == Form::power_double_double) {
      std::vector<double> low(in.size());
      exact(in, out, low, target);
      copy(out, result.high, axis);
      copy(low, result.low, axis);
    } else {
      exact(in, out, target);
      copy(out, result, axis);
    }
  }
  return result;
}

}  // namespace detail

struct ExactToPower {
  static constexpr MethodInfo info{.id = "exact",
                                   .label = "Exact, then rounded",
                                   .problem = Problem::conversion,
                                   .form = Form::bernstein,
                                   .max_degree = max_degree_to_power,
                                   .max_degree_float = max_degree_to_power_float,
                                   .bound = ErrorBound{.text = "u sum |b_i| C(n,i) t^i (1+t)^(n-i)",
                                                       .amplification = Amplification::bernstein_to_power,
                                                       .factor = [](int, double) { return 1.0; },
                                                       .underflow = [](int n) { return n + 1.0; },
                                                       .underflow_scales_with_coefficients = true,
                                                       .growth = growth_to_power},
                                   .flops = "big integers, per curve",
                                   .cost_exponent = 3,
                                   .citation = "[Farouki 2012], the definition, in exact arithmetic"};

  static constexpr Form target = Form::power;
  static constexpr bool of_differences = true;
  static constexpr double coefficient_growth(int n) { return growth_to_power(n); }

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::power, Scalar, Dimension, Degree> convert(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    return detail::convert_axes<Form::power>(curve, exact_to_power);
  }
};

struct ExactToPowerDoubleDouble {
  static constexpr MethodInfo info = [] {
    MethodInfo own = ExactToPower::info;
    own.id = "exact_dd";
    own.label = "Exact, then rounded to double-double";
    own.bound->text = "u^2 sum |b_i| C(n,i) t^i (1+t)^(n-i)";
    own.bound->factor = [](int, double u) { return u; };
    return own;
  }();

  static constexpr Form target = Form::power_double_double;
  static constexpr double coefficient_growth(int n) { return growth_to_power(n); }

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::power_double_double, Scalar, Dimension, Degree> convert(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    return detail::convert_axes<Form::power_double_double>(curve, exact_to_power_double_double);
  }
};

struct ExactToPowerCentered {
  static constexpr MethodInfo info = [] {
    MethodInfo own = ExactToPower::info;
    own.id = "exact_centered";
    own.label = "Exact about t = 1/2, then rounded";
    own.bound->text = "u sum |b_i| C(n,i) (1/2 + |t - 1/2|)^n";
    own.bound->amplification = Amplification::bernstein_to_centered;
    own.cost_exponent = 4;
    return own;
  }();

  static constexpr Form target = Form::power_centered;
  static constexpr double coefficient_growth(int n) { return growth_to_power(n); }

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::power_centered, Scalar, Dimension, Degree> convert(
      const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    return detail::convert_axes<Form::power_centered>(curve, exact_to_power_centered);
  }
};

struct ExactToBernstein {
  static constexpr MethodInfo info{.id = "exact",
                                   .label = "Exact, then rounded",
                                   .problem = Problem::conversion,
                                   .form = Form::power,
                                   .bound = ErrorBound{.text = "u sum |q_j| t^j on [0,1]",
                                                       .amplification = Amplification::power_to_bernstein,
                                                       .factor = [](int, double) { return 1.0; },
                                                       .underflow = [](int) { return 1.0; },
                                                       .underflow_scales_with_coefficients = true,
                                                       .growth = growth_to_bernstein},
                                   .flops = "big integers, per curve",
                                   .cost_exponent = 4,
                                   .citation = "[Farouki and Rajan 1987], in exact arithmetic"};

  static constexpr Form target = Form::bernstein;
  static constexpr double coefficient_growth(int n) { return growth_to_bernstein(n); }

  template <class Scalar, int Dimension, int Degree>
  static Curve<Form::bernstein, Scalar, Dimension, Degree> convert(
      const Curve<Form::power, Scalar, Dimension, Degree>& curve) {
    return detail::convert_axes<Form::bernstein>(curve, exact_to_bernstein);
  }
};

}  // namespace bezierbench
