// SPDX-License-Identifier: MIT
#include "experiments/race/operation_times.hpp"

#include <gtest/gtest.h>

#include "core/batch/batch.hpp"

namespace bezierbench::race {
namespace {

template <class Scalar>
void expect_plausible() {
  const auto times = measured_operations<Scalar>(steady_ns);
  ASSERT_EQ(times.size(), batch::works_of<Scalar>(*batch::usable_targets().front()).size());
  std::size_t lanes = 16 / sizeof(Scalar);
  for (const auto& width : times) {
    EXPECT_EQ(width.lanes, lanes);
    lanes *= 2;
    for (std::size_t kind = 0; kind < operation_kinds; ++kind) {
      EXPECT_GT(width.apart.values[kind], 0.01) << "a twentieth of a cycle";
      EXPECT_LT(width.apart.values[kind], 1.5 * width.latency.values[kind])
          << "a chain waits, or nearly, for divisions";
    }
    // By factors that no disturbance makes.
    EXPECT_LT(width.mixed, width.latency[Operation::fused]);
    EXPECT_LT(width.apart[Operation::fused] * 2, width.latency[Operation::fused]) << "multiply-adds are pipelined";
    EXPECT_LT(width.apart[Operation::fused] * 2, width.apart[Operation::divide]) << "divisions are not";
  }
}

TEST(OperationTimes, AreThoseOfAProcessor) {
  if (batch::usable_targets().empty()) GTEST_SKIP() << "this processor has no target";
  expect_plausible<float>();
  expect_plausible<double>();
}

TEST(OperationTimes, OfSeveralMeasurementsAreTheMedians) {
  const auto one = [](double ns) {
    return ProcessorTimes{
        {.lanes = 2, .apart = {{ns, 2 * ns, 0, 0, 0}}, .latency = {{0, 0, 0, 0, 3 * ns}}, .mixed = ns}};
  };
  const auto median = median_of({one(4), one(1), one(2)});
  ASSERT_EQ(median.size(), 1U);
  EXPECT_EQ(median[0].lanes, 2U);
  EXPECT_EQ(median[0].apart[Operation::add], 2);
  EXPECT_EQ(median[0].apart[Operation::multiply], 4);
  EXPECT_EQ(median[0].latency[Operation::square_root], 6);
  EXPECT_EQ(median[0].mixed, 2);
  EXPECT_TRUE(median_of({}).empty());
}

}  // namespace
}  // namespace bezierbench::race
