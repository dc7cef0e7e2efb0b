// SPDX-License-Identifier: MIT
// Methods of every kind from headers alone; exit 0 where the points are right and the arithmetic is kept.
#include <bezierbench/core/api/floating_point.hpp>
#include <bezierbench/evaluate.hpp>
#include <vector>

int main() {
  const std::vector<std::array<double, 2>> points{{0, 0}, {1, 2}, {3, 1}};
  const std::array<double, 2> expected{0.5625, 0.8125};
  const bool right =
      bezierbench::evaluate(points, 0.25) == expected &&
      bezierbench::evaluate<bezierbench::CompensatedDeCasteljau>(points, 0.25) == expected &&
      bezierbench::evaluate<bezierbench::Via<bezierbench::Differences, bezierbench::Horner>>(points, 0.25) == expected;
  return right && bezierbench::keeps_arithmetic() ? 0 : 1;
}
