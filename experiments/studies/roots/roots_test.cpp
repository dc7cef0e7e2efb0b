// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "experiments/studies/roots/problem.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(RootsStudy, AnswersBelongToTheNearestRoot) {
  const std::vector<reference::Root> roots{{0.25, 1}, {0.5, 2}, {0.75, 1}};
  const auto match = matched(roots, {0.25, 0.25 + 0x1p-30, 0.5 - 0x1p-20, 0.6});
  EXPECT_EQ(match.error, (std::vector<double>{0, 0x1p-20, infinity}));
  EXPECT_EQ(match.root_of, (std::vector<std::size_t>{0, 0, 1, 3}));
  EXPECT_EQ(match.spurious, 2U);
  EXPECT_EQ(matched({}, {0.5}).spurious, 1U);
}

TEST(RootsStudy, EnclosuresAreJudged) {
  const std::vector<reference::Root> roots{{0.25, 1}, {0.5, 2}};
  EXPECT_TRUE(keeps_enclosures(roots, {{0.2, 0.3, true}, {0.5, 0.5, true}}));
  EXPECT_TRUE(keeps_enclosures(roots, {{0.2, 0.6, false}}));
  EXPECT_TRUE(keeps_enclosures(roots, {{0, 0.1, false}, {0.2, 0.3, true}, {0.4, 0.6, false}}));
  EXPECT_TRUE(keeps_enclosures(roots, {{0.2, 0.25, true}, {0.25, 0.6, false}}));                  // on a common end
  EXPECT_FALSE(keeps_enclosures(roots, {{0.2, 0.3, true}}));                                      // a root outside
  EXPECT_FALSE(keeps_enclosures(roots, {{0.2, 0.6, true}, {0.7, 0.8, false}}));                   // two roots in one
  EXPECT_FALSE(keeps_enclosures(roots, {{0.2, 0.3, true}, {0.4, 0.6, true}, {0.7, 0.8, true}}));  // none in one
  EXPECT_FALSE(keeps_enclosures(roots, {{0, 0.1, true}, {0.2, 0.6, false}}));
  EXPECT_TRUE(keeps_enclosures({}, {}));
}

/// A method that breaks its promise is reported; one without a promise only misses.
TEST(RootsStudy, APromiseIsJudged) {
  RootsProblem::Drawn drawn;
  const std::vector<double> b{-1, 1};
  drawn.curve = {Form::bernstein, 1, 1, b};
  drawn.value = {0};
  RootsProblem::find_truth(drawn);
  for (const auto& method : RootsProblem::kernels(1)) {
    RootsErrors errors;
    RootsProblem::judge(method, drawn, 0, {FoundRoots{}}, 3, errors);
    EXPECT_EQ(errors.missed_odd, 1U);
    EXPECT_EQ(errors.broken.count, method.info->promise.empty() ? 0U : 1U) << method.info->id;
    EXPECT_FALSE(RootsProblem::is_right(method, drawn, 0, {FoundRoots{}}));
  }
}

/// The root of (t - 3/4)^n counts once, whatever its multiplicity.
TEST(RootsStudy, MultipleRootsAreCountedOnce) {
  auto study = small_study("roots");
  study.dimension = {1};
  study.degree = {2, 3};
  study.generator = {"multiple_root"};
  study.trials = 1;
  const auto csv = rows_of(study, "roots.csv");
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "polynomials"), "1");
    EXPECT_EQ(csv.at(row, "roots"), "1");
    const auto& method = csv.at(row, "method");
    if (method == "closed_form") {
      EXPECT_EQ(csv.at(row, "right_count"), "1");
    }
    if (method == "certified") {
      EXPECT_EQ(csv.at(row, "missed"), "0");
    }
  }
}

}  // namespace
}  // namespace bezierbench::studies
