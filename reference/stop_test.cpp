// SPDX-License-Identifier: MIT
#include "reference/stop.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "reference/companion/bspline_control_points.hpp"
#include "reference/companion/projection.hpp"
#include "reference/length/length_truth.hpp"
#include "reference/length/true_length.hpp"

namespace bezierbench::reference {
namespace {

const std::vector<double> points_of_cubic{0, 0, 1, 2, 3, 2, 4, 1};
const CurveView<double> cubic{Form::bernstein, 2, 3, points_of_cubic};

/// The computations that take minutes at high degrees.
const std::vector<std::function<void()>> truths{
    [] { TrueLength(cubic, 0, 0.5); },
    [] { LengthAlong<LongReal>{cubic}; },
    [] {
      ExactBsplineWeights::at(std::vector<double>{0, 1, 2, 3}, 1.5);
    },
    [] {
      projection(cubic, std::vector<double>{1, 1});
    },
};

TEST(Stop, EndsEveryLongComputationOfTheTruth) {
  for (const auto& truth : truths) {
    const StopWhen stop([] { return true; });
    EXPECT_THROW(truth(), Stopped);
  }
}

TEST(Stop, IsAskedForByEveryConditionThatIsInForce) {
  const StopWhen outer([] { return true; });
  const StopWhen inner([] { return false; });
  EXPECT_THROW(truths.front()(), Stopped);
}

TEST(Stop, IsOverWithItsObject) {
  {
    const StopWhen stop([] { return true; });
  }
  for (const auto& truth : truths) EXPECT_NO_THROW(truth());
}

}  // namespace
}  // namespace bezierbench::reference
