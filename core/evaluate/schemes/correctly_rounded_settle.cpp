// SPDX-License-Identifier: MIT
#include <cmath>

#include "core/evaluate/methods/correctly_rounded.hpp"
#include "core/evaluate/methods/correctly_rounded_power.hpp"
#include "core/powers.hpp"

namespace bezierbench {
namespace {

/// The coefficients of one coordinate as a curve.
template <class ScalarT>
struct OneAxis {
  using Scalar = ScalarT;
  static constexpr int dimension = 1;
  static constexpr int fixed_degree = dynamic;

  [[nodiscard]] int degree() const { return coefficients.degree; }
  [[nodiscard]] Scalar operator()(int /*axis*/, int i) const { return coefficients[i]; }

  CoordinateView<Scalar> coefficients;
};

template <class Scalar>
struct OneAxisPairs {
  explicit OneAxisPairs(const AxisState<Scalar>& axis) : scaled{axis.scaled}, lost{axis.lost} {}

  OneAxis<Scalar> scaled;
  OneAxis<Scalar> lost;
};

/// The rounding test with a bound on the error of this point. p~ was summed in double with less than 8n roundings.
template <class Scalar>
Scalar decided_at(const AxisState<Scalar>& axis, const Expansion2<Scalar>& pair, double factor, double p_tilde) {
  constexpr double u = std::numeric_limits<Scalar>::epsilon() / 2;
  constexpr double rounded_up = 1 + 0x1p-20;
  constexpr double lost_to_underflow = sizeof(Scalar) == sizeof(double) ? 0x1p-1000 : 0x1p-120;
  auto rounding = axis.rounding;
  rounding.error = static_cast<Scalar>((factor * u * u * p_tilde + lost_to_underflow) * rounded_up);
  return decided<Scalar>(pair, rounding);
}

}  // namespace

template <class Scalar>
Scalar settled_by_p_tilde(const AxisState<Scalar>& axis, Scalar t, Form form) {
  const int n = axis.scaled.degree;
  if (!std::isfinite(axis.rounding.error) || !(t >= 0 && t <= 1)) return undecided<Scalar>();
  const double x = t;
  const double y = 1 - x;
  double p_tilde = 0;
  if (form == Form::power) {
    for (int j = n; j >= 0; --j) p_tilde = p_tilde * x + std::abs(static_cast<double>(axis.scaled[j]));
    const auto pair = CorrectlyRoundedPower::pairs<1>(OneAxisPairs<Scalar>(axis), t)[0];
    return decided_at(axis, pair, CorrectlyRoundedPower::pair_factor(n), p_tilde);
  }
  const bool near_start = x <= 0.5;
  const double ratio = near_start ? x / y : y / x;
  for (int i = n; i >= 0; --i)
    p_tilde = p_tilde * ratio + std::abs(static_cast<double>(axis.scaled[near_start ? i : n - i]));
  p_tilde *= integer_power(near_start ? y : x, n);
  const auto pair = CorrectlyRounded::pairs<1>(OneAxisPairs<Scalar>(axis), t)[0];
  return decided_at(axis, pair, CorrectlyRounded::pair_factor(n), p_tilde);
}

template <class Scalar>
Scalar settled(const AxisState<Scalar>& axis, Scalar t, Form form) {
  return or_else(settled_by_p_tilde(axis, t, form), t, [&](Scalar at) {
    return form == Form::power ? rounded_power_sum(axis.given, at) : rounded_bernstein_sum(axis.given, at);
  });
}

template float settled_by_p_tilde(const AxisState<float>&, float, Form);
template double settled_by_p_tilde(const AxisState<double>&, double, Form);
template float settled(const AxisState<float>&, float, Form);
template double settled(const AxisState<double>&, double, Form);

}  // namespace bezierbench
