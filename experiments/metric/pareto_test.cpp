// SPDX-License-Identifier: MIT
#include "experiments/metric/pareto.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace bezierbench::metric {
namespace {

Tradeoff sharp(double time, double error) { return {{time, time, time}, error}; }

std::vector<Front> front_of(const std::vector<Tradeoff>& methods) { return pareto_front(methods); }

TEST(ParetoFront, KeepsWhatNoOtherBeatsInBoth) {
  EXPECT_EQ(front_of({sharp(1, 9), sharp(2, 4), sharp(3, 5), sharp(4, 1)}),
            (std::vector{Front::on, Front::on, Front::off, Front::on}));
}

TEST(ParetoFront, DropsTheSlowerOfTwoThatAreEquallyRight) {
  EXPECT_EQ(front_of({sharp(1, 4), sharp(2, 4)}), (std::vector{Front::on, Front::off}));
}

TEST(ParetoFront, KeepsBothOfTwoThatAreAlike) {
  EXPECT_EQ(front_of({sharp(1, 4), sharp(1, 4)}), (std::vector{Front::on, Front::on}));
}

TEST(ParetoFront, IsUnresolvedWhereTheTimesOverlap) {
  const Tradeoff quick{{1.0, 0.9, 1.2}, 4};
  const Tradeoff slow{{1.1, 1.0, 1.3}, 5};
  EXPECT_EQ(front_of({quick, slow}), (std::vector{Front::on, Front::unresolved}));
}

TEST(ParetoFront, ACertainRivalOutweighsADoubtfulOne) {
  const Tradeoff doubtful{{1.0, 0.9, 1.2}, 4};
  const Tradeoff slow{{1.1, 1.0, 1.3}, 5};
  EXPECT_EQ(front_of({doubtful, slow, sharp(0.5, 5)}).at(1), Front::off);
}

TEST(ParetoFront, TakesNonFiniteResultsForInfinitelyWrong) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(front_of({sharp(1, infinite), sharp(2, infinite), sharp(3, 1)}),
            (std::vector{Front::on, Front::off, Front::on}));
}

TEST(ParetoFront, OfNoneIsNone) { EXPECT_TRUE(front_of({}).empty()); }

}  // namespace
}  // namespace bezierbench::metric
