// SPDX-License-Identifier: MIT
#include "reference/companion/exact_bspline.hpp"

#include <cassert>

#include "reference/stop.hpp"

namespace bezierbench::reference {

ExactBsplineWeights::ExactBsplineWeights(std::span<const double> knots, std::span<const double> arguments)
    : weights_(arguments.size() + 1) {
  const std::size_t m = arguments.size();
  assert(knots.size() == 2 * m);
  std::vector<mpq_class> u;
  for (const double knot : knots) u.emplace_back(require_finite(knot));
  weights_[0] = 1;
  for (std::size_t r = 1; r <= m; ++r) {
    const mpq_class x = require_finite(arguments[r - 1]);
    mpq_class carried = 0;
    for (std::size_t i = 0; i < r; ++i) {
      StopWhen::poll();
      const mpq_class& left = u[m - r + i];
      const mpq_class& right = u[m + i];
      const mpq_class share = weights_[i] / (right - left);
      weights_[i] = carried + (right - x) * share;
      carried = (x - left) * share;
    }
    weights_[r] = carried;
  }
}

ExactBsplineWeights ExactBsplineWeights::at(std::span<const double> knots, double t) {
  return {knots, std::vector<double>(knots.size() / 2, t)};
}

ExactBsplineWeights ExactBsplineWeights::of_control_point(std::span<const double> knots, int k) {
  const std::size_t m = knots.size() / 2;
  std::vector<double> arguments(m, knots[m - 1]);
  for (std::size_t i = m - static_cast<std::size_t>(k); i < m; ++i) arguments[i] = knots[m];
  return {knots, arguments};
}

ExactBsplineWeights ExactBsplineWeights::with(std::span<const double> weights) const {
  assert(weights.size() == weights_.size());
  auto result = *this;
  mpq_class total = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    result.weights_[i] *= mpq_class(require_finite(weights[i]));
    total += result.weights_[i];
  }
  for (auto& weight : result.weights_) weight /= total;
  return result;
}

ExactPoint ExactBsplineWeights::sum(int dimension, std::span<const double> control_points) const {
  const auto d = static_cast<std::size_t>(dimension);
  assert(dimension <= max_dimension && control_points.size() == weights_.size() * d);
  std::vector<mpq_class> sums(d);
  for (std::size_t i = 0; i < weights_.size(); ++i)
    for (std::size_t axis = 0; axis < d; ++axis)
      sums[axis] += weights_[i] * mpq_class(require_finite(control_points[i * d + axis]));
  ExactPoint point;
  point.dimension = dimension;
  for (const auto& sum : sums)
    mpz_lcm(point.denominator.get_mpz_t(), point.denominator.get_mpz_t(), sum.get_den_mpz_t());
  for (std::size_t axis = 0; axis < d; ++axis)
    point.numerator[axis] = sums[axis].get_num() * (point.denominator / sums[axis].get_den());
  return point;
}

}  // namespace bezierbench::reference
