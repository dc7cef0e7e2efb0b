// SPDX-License-Identifier: MIT
// Curves from a seed, and a kernel asked for their points: what tests and properties of evaluators share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <random>
#include <vector>

#include "core/evaluate/kernel/prepared_state.hpp"
#include "core/method.hpp"

namespace bezierbench::requirements {

/// Deterministic inputs that depend on no library's distribution.
class Inputs {
 public:
  explicit Inputs(std::uint64_t seed) : words_(seed) {}
  double symmetric() { return static_cast<double>(static_cast<std::int64_t>(words_())) * 0x1p-63; }
  double unit() { return static_cast<double>(words_() >> 11U) * 0x1p-53; }
  std::vector<double> coefficients(int degree, int dimension) {
    std::vector<double> result(static_cast<std::size_t>((degree + 1) * dimension));
    for (double& value : result) value = symmetric();
    return result;
  }

 private:
  std::mt19937_64 words_;
};

/// A curve as methods take it; in the rational form with mild weights that follow from the degree.
template <class Scalar>
CurveView<Scalar> view(Form form, int dimension, int degree, const std::vector<Scalar>& coefficients) {
  if (form != Form::rational) return {form, dimension, degree, coefficients};
  static std::map<int, std::vector<Scalar>> weights;
  auto& w = weights[degree];
  for (int i = static_cast<int>(w.size()); i <= degree; ++i)
    w.push_back(static_cast<Scalar>(12 + (7 * i + 3) % 11) / 16);  // 3/4 .. 11/8
  return {form, dimension, degree, coefficients, w};
}

/// The points at every t, one after the other.
template <class Scalar>
std::vector<Scalar> evaluate(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve,
                             const std::vector<Scalar>& t) {
  std::vector<Scalar> points(t.size() * static_cast<std::size_t>(curve.dimension));
  PreparedState<Scalar>(kernel, curve).evaluate(t, points.data());
  return points;
}

// The parameters and degrees at which properties are decided.

/// The ends, their neighbours, the middle, and both sides of [0, 1].
inline std::vector<double> parameters() { return {0, 1, 0.5, 0.3, 0x1p-30, 1 - 0x1p-53, 0.9, -0.25, 1.5}; }

/// Those at which the method has a value: outside [0, 1] sums of weights may vanish, and some methods end there.
inline std::vector<double> parameters_for(const MethodInfo& info) {
  auto ts = parameters();
  if (info.form == Form::rational || info.unit_interval_only)
    std::erase_if(ts, [](double t) { return t < 0 || t > 1; });
  return ts;
}

/// Those of `degrees` that the method takes.
template <class Scalar = double>
std::vector<int> degrees_for(const MethodInfo& info, std::initializer_list<int> degrees) {
  std::vector<int> taken = degrees;
  std::erase_if(taken, [&](int degree) { return !info.supports<Scalar>(degree); });
  return taken;
}

}  // namespace bezierbench::requirements
