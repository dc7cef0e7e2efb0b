// SPDX-License-Identifier: MIT
// A method as the statements see it: points of curves, from the kernel that is timed.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/judge/workspace.hpp"

namespace bezierbench::guarantees {

inline constexpr int most_axes = 3;

/// Coordinates of a point; those past the dimension are 0.
template <class Scalar>
using Values = std::array<Scalar, most_axes>;

template <class Scalar>
class Evaluation {
 public:
  explicit Evaluation(const Kernel<Scalar>& kernel) : kernel_(kernel) {}

  /// The points at all `t` of the curve with these control points, which is prepared once.
  template <std::size_t Count>
  std::array<Values<Scalar>, Count> points(const std::vector<Scalar>& coefficients,
                                           const std::array<Scalar, Count>& t) {
    const int degree = static_cast<int>(coefficients.size()) / kernel_.dimension - 1;
    void* prepared = storage_.reserve(kernel_.prepared_size);
    kernel_.prepare({Form::bernstein, kernel_.dimension, degree, coefficients}, prepared);
    std::array<Scalar, Count * most_axes> flat;
    kernel_.evaluate_for(degree)(prepared, t, flat.data());
    if (kernel_.destroy != nullptr) kernel_.destroy(prepared);
    std::array<Values<Scalar>, Count> points{};
    const auto d = static_cast<std::size_t>(kernel_.dimension);
    for (std::size_t k = 0; k < Count; ++k)
      for (std::size_t axis = 0; axis < d; ++axis) points[k][axis] = flat[k * d + axis];
    return points;
  }
  Values<Scalar> point(const std::vector<Scalar>& coefficients, Scalar t) {
    return points(coefficients, std::array{t})[0];
  }

 private:
  const Kernel<Scalar>& kernel_;
  judge::PreparedStorage storage_;
};

}  // namespace bezierbench::guarantees
