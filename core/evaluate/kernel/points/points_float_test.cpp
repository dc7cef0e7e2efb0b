// SPDX-License-Identifier: MIT
#include "core/evaluate/kernel/points/points_test.hpp"

namespace bezierbench {
namespace {

template <class E>
class PointsInFloat : public testing::Test {};

TYPED_TEST_SUITE(PointsInFloat, points_test::EveryEvaluator, points_test::ByMethod);

TYPED_TEST(PointsInFloat, HaveTheBitsOfTheMethodForNumbers) {
  points_test::expect_every_way_to_agree<TypeParam, float>();
}

}  // namespace
}  // namespace bezierbench
