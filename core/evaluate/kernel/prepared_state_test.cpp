// SPDX-License-Identifier: MIT
#include "core/evaluate/kernel/prepared_state.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace bezierbench {
namespace {

constexpr std::size_t alignment = 256;
int prepared = 0;
int destroyed = 0;
bool is_aligned = false;

/// Counts what it prepares and destroys.
Kernel<double> counting_kernel() {
  Kernel<double> kernel{};
  kernel.dimension = 1;
  kernel.prepared_size = 8;
  kernel.prepared_alignment = alignment;
  kernel.prepare = [](const CurveView<double>& curve, void* state) {
    ++prepared;
    is_aligned = reinterpret_cast<std::uintptr_t>(state) % alignment == 0;
    *static_cast<double*>(state) = curve.coefficients[0];
  };
  kernel.evaluate_for = [](int) -> EvaluatePoints<double> {
    return [](const void* state, std::span<const double> t, double* points) {
      for (std::size_t k = 0; k < t.size(); ++k) points[k] = *static_cast<const double*>(state) + t[k];
    };
  };
  kernel.destroy = [](void*) { ++destroyed; };
  return kernel;
}

TEST(PreparedState, IsAlignedAndDestroyedOnceThoughItMoves) {
  const auto kernel = counting_kernel();
  const std::vector<double> coefficients{3};
  {
    PreparedState<double> state(kernel, {Form::bernstein, 1, 0, coefficients});
    EXPECT_TRUE(is_aligned);
    const auto moved = std::move(state);
    const std::vector<double> t{0.25, 0.5};
    std::vector<double> points(2);
    moved.evaluate(t, points.data());
    EXPECT_EQ(points, (std::vector<double>{3.25, 3.5}));
    EXPECT_EQ(&moved.kernel(), &kernel);
    EXPECT_EQ(destroyed, 0);
  }
  EXPECT_EQ(prepared, 1);
  EXPECT_EQ(destroyed, 1);
}

}  // namespace
}  // namespace bezierbench
