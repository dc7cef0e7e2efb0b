// SPDX-License-Identifier: MIT
#include "core/evaluate/kernel/points/points_test.hpp"

namespace bezierbench {
namespace {

template <class E>
class PointsInDouble : public testing::Test {};

TYPED_TEST_SUITE(PointsInDouble, points_test::EveryEvaluator, points_test::ByMethod);

TYPED_TEST(PointsInDouble, HaveTheBitsOfTheMethodForNumbers) {
  points_test::expect_every_way_to_agree<TypeParam, double>();
}

}  // namespace
}  // namespace bezierbench
