// SPDX-License-Identifier: MIT
// Curves from a seed, and a kernel asked for their points: what tests and properties of evaluators share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include "core/evaluate/kernel.hpp"

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

/// What a kernel prepares for a curve.
template <class Scalar>
class PreparedState {
 public:
  PreparedState(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve)
      : kernel_(kernel),
        space_(kernel.prepared_size + kernel.prepared_alignment),
        memory_(std::make_unique<std::byte[]>(space_)),
        state_(memory_.get()) {
    std::align(kernel.prepared_alignment, kernel.prepared_size, state_, space_);
    kernel.prepare(curve, state_);
  }
  PreparedState(const PreparedState&) = delete;
  PreparedState& operator=(const PreparedState&) = delete;
  PreparedState(PreparedState&&) = delete;
  PreparedState& operator=(PreparedState&&) = delete;
  ~PreparedState() {
    if (kernel_.destroy != nullptr) kernel_.destroy(state_);
  }

  [[nodiscard]] const void* get() const { return state_; }

 private:
  const Kernel<Scalar>& kernel_;
  std::size_t space_;
  std::unique_ptr<std::byte[]> memory_;
  void* state_;
};

/// The points at every t, one after the other.
template <class Scalar>
std::vector<Scalar> evaluate(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve,
                             const std::vector<Scalar>& t) {
  const PreparedState<Scalar> prepared(kernel, curve);
  std::vector<Scalar> points(t.size() * static_cast<std::size_t>(curve.dimension));
  kernel.evaluate(prepared.get(), t, points.data());
  return points;
}

}  // namespace bezierbench::requirements
