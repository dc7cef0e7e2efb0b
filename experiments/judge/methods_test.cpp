// SPDX-License-Identifier: MIT
#include "experiments/judge/methods.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/failure.hpp"

namespace bezierbench::judge {
namespace {

sample::Cell cell_of(const suite::Interval& t_interval) {
  sample::Cell cell;
  cell.degree = 3;
  cell.t_interval = t_interval;
  return cell;
}

bool chooses(const suite::Study& study, const suite::Interval& t_interval, std::string_view id) {
  const auto chosen = chosen_kernels<double>(study, cell_of(t_interval));
  return std::ranges::any_of(chosen, [&](const auto* kernel) { return kernel->info->id == id; });
}

TEST(MethodChoice, LeavesOutAMethodWhereTLeavesItsDomain) {
  suite::Study study;
  study.t_interval = {{0, 1}, {-1, 2}};
  for (const suite::Interval inside : {suite::Interval{0, 1}, suite::Interval{0.25, 0.5}}) {
    EXPECT_TRUE(chooses(study, inside, "correctly_rounded"));
    EXPECT_TRUE(chooses(study, inside, "de_casteljau"));
  }
  for (const suite::Interval outside :
       {suite::Interval{-1, 2}, suite::Interval{-0x1p-1074, 1}, suite::Interval{0, 1.5}}) {
    EXPECT_FALSE(chooses(study, outside, "correctly_rounded"));
    EXPECT_FALSE(chooses(study, outside, "exact:correctly_rounded"));  // the domain of a path is that of its evaluator
    EXPECT_TRUE(chooses(study, outside, "de_casteljau"));
  }
  EXPECT_TRUE(chooses(study, {0, 1}, "exact:correctly_rounded"));
}

TEST(MethodChoice, RefusesANamedMethodWithoutAnyCell) {
  suite::Study study;
  study.methods = {"correctly_rounded"};
  study.t_interval = {{-1, 2}};
  EXPECT_THROW(chosen_kernels<double>(study, cell_of({-1, 2})), Failure);
  study.t_interval = {{-1, 2}, {0, 1}};  // a sweep of intervals has one for it
  EXPECT_TRUE(chosen_kernels<double>(study, cell_of({-1, 2})).empty());
  EXPECT_TRUE(chooses(study, {0, 1}, "correctly_rounded"));
}

}  // namespace
}  // namespace bezierbench::judge
