// SPDX-License-Identifier: MIT
#include "experiments/race/limit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/batch/batch.hpp"
#include "core/evaluate/kernel/kernel.hpp"

namespace bezierbench::race {
namespace {

/// A processor that starts two operations of every kind but division in a nanosecond, additions beside the others.
OperationTimes times_of(std::size_t lanes) {
  return {.lanes = lanes, .apart = {{0.5, 0.5, 0.5, 4, 6}}, .latency = {{3, 3, 4, 13, 20}}, .mixed = 0.25};
}

TEST(LeastTime, IsThatOfTheBusiestUnits) {
  const auto times = times_of(2);
  EXPECT_EQ(least_ns({{8, 1, 1, 0, 0}}, times), 4) << "additions";
  EXPECT_EQ(least_ns({{1, 5, 3, 0, 0}}, times), 4) << "products and fused multiply-adds have the same units";
  EXPECT_EQ(least_ns({{8, 4, 4, 0, 0}}, times), 4) << "beside the additions";
  EXPECT_EQ(least_ns({{8, 4, 4, 1, 1}}, times), 10) << "divisions and square roots have one unit";
  EXPECT_EQ(least_ns({}, times), 0);
}

// Where one set of units does all, additions take the time of products away.
TEST(LeastTime, AddsUpWhereUnitsAreShared) {
  auto shared = times_of(2);
  shared.mixed = 0.5;
  EXPECT_EQ(least_ns({{8, 4, 4, 0, 0}}, shared), 8);
}

// A measurement of the mixture that was disturbed cannot make operations slower than they are alone.
TEST(LeastTime, IsNoLongerThanOfEachKindAlone) {
  auto disturbed = times_of(2);
  disturbed.mixed = 100;
  EXPECT_EQ(least_ns({{8, 0, 0, 0, 0}}, disturbed), 4);
}

TimedWork work(std::string_view id, Form form, int degree, int dimension) {
  const auto& kernel = *find_kernel<double>(id, form, 2);
  return {kernel.evaluator, kernel.conversion, degree, dimension};
}

// de Casteljau at degree 3: 1 - t, and 6 steps on an axis of two products and a sum each.
TEST(Limit, CountsTheAxesOfAPointInOneVector) {
  const ProcessorTimes times{times_of(2), times_of(4)};
  for (const int dimension : {1, 2, 3}) {
    const auto found = limit(work("de_casteljau", Form::bernstein, 3, dimension), suite::Mode::point, times);
    EXPECT_EQ(found->ns, 6);
    EXPECT_EQ(found->chain_ns, 3 + 3 * 6);
  }
}

TEST(Limit, TakesTheNarrowestVectorThatHoldsThem) {
  auto wide = times_of(4);
  wide.apart[Operation::multiply] = 1;
  const auto ns = [&](Form form, int dimension) {
    return limit(work("de_casteljau", form, 3, dimension), suite::Mode::point, {times_of(2), wide})->ns;
  };
  EXPECT_EQ(ns(Form::bernstein, 2), 6);
  EXPECT_EQ(ns(Form::bernstein, 3), 12);
  EXPECT_EQ(ns(Form::rational, 1), 6) << "the weight goes with one coordinate";
  EXPECT_EQ(ns(Form::rational, 2), 12);
}

TEST(Limit, TakesSeveralVectorsWhereNoneIsWideEnough) {
  EXPECT_EQ(limit(work("de_casteljau", Form::bernstein, 3, 3), suite::Mode::point, {times_of(2)})->ns, 12);
}

TEST(Limit, OfAChainFollowsIt) {
  const ProcessorTimes times{times_of(2)};
  EXPECT_EQ(limit(work("horner_fma", Form::power, 5, 2), suite::Mode::latency, times)->ns, 20);
  EXPECT_EQ(limit(work("horner_fma", Form::power, 5, 2), suite::Mode::point, times)->ns, 2.5);
  const auto division = limit(work("wozny_chudy", Form::bernstein, 5, 2), suite::Mode::latency, times);
  EXPECT_EQ(division->ns, division->chain_ns);
}

TEST(Limit, OfOneShotHasThePreparation) {
  const ProcessorTimes times{times_of(2)};
  const auto point = limit(work("differences:horner_fma", Form::bernstein, 5, 2), suite::Mode::point, times);
  const auto one_shot = limit(work("differences:horner_fma", Form::bernstein, 5, 2), suite::Mode::one_shot, times);
  EXPECT_EQ(point->ns, 2.5);
  EXPECT_EQ(one_shot->ns, 7.5) << "15 differences; 6 products with binomials and 5 steps go beside them";
  EXPECT_EQ(one_shot->chain_ns, std::nullopt);
}

TEST(Limit, OfABatchFillsEveryLane) {
  const auto lanes = [](int dimension, const ProcessorTimes& times) {
    return limit(work("horner_fma", Form::power, 8, dimension), suite::Mode::batch, times)->ns;
  };
  EXPECT_EQ(lanes(1, {times_of(2)}), 2);
  EXPECT_EQ(lanes(3, {times_of(2), times_of(8)}), 1.5);
}

TEST(Limit, IsUnknownWhereNothingWasCountedOrMeasured) {
  const ProcessorTimes times{times_of(2)};
  EXPECT_EQ(limit(work("direct_pow", Form::bernstein, 5, 2), suite::Mode::point, times), std::nullopt);
  EXPECT_EQ(limit(work("direct_pow", Form::bernstein, 5, 2), suite::Mode::batch, times), std::nullopt);
  EXPECT_EQ(limit(work("exact:horner", Form::bernstein, 5, 2), suite::Mode::one_shot, times), std::nullopt);
  EXPECT_NE(limit(work("exact:horner", Form::bernstein, 5, 2), suite::Mode::point, times), std::nullopt);
  EXPECT_EQ(limit(work("horner", Form::power, 5, 2), suite::Mode::point, {}), std::nullopt);
}

TEST(ShareOfLimit, IsOfTheTimeWithoutTheCall) {
  EXPECT_EQ(share_of_limit(3, 8, 2), 0.5);
  EXPECT_EQ(share_of_limit(3, 4, 2), 1.5);
  EXPECT_TRUE(std::isinf(share_of_limit(3, 2, 2)));
  EXPECT_TRUE(std::isinf(share_of_limit(3, 1, 2)));
}

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
