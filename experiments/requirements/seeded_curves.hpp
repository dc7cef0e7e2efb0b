// SPDX-License-Identifier: MIT
// Curves from a seed, and a kernel asked for their points: what tests and properties of evaluators share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "core/evaluate/prepared_state.hpp"

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

}  // namespace bezierbench::requirements
