// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>

#include "experiments/sample/placement.hpp"
#include "experiments/studies/projection/problem.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

suite::Study projection_study_of(std::vector<std::string> methods) {
  auto study = small_study("projection", std::move(methods));
  study.degree = {3};
  study.dimension = {2, 3};
  study.trials = 120;
  return study;
}

TEST(ProjectionStudy, IsolationMissesNothingAndKeepsItsGoal) {
  const auto csv = rows_of(projection_study_of({"quintic_isolate"}), "projection.csv");
  ASSERT_EQ(csv.row_count(), 2 * sample::placements().size());
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "missed"), "0") << row;
    EXPECT_EQ(csv.at(row, "non_converged"), "0") << row;
    EXPECT_EQ(csv.at(row, "trials"), "120") << row;
    EXPECT_LE(run::number_at(csv, row, "max_error_eps"), 4) << row;
    EXPECT_GE(run::number_at(csv, row, "candidates"), 240) << row;  // the two ends of each curve
  }
}

/// Among them the centre of curvature and cusps, where t has a third of its digits.
TEST(ProjectionStudy, EveryOwnMethodKeepsItsBoundOfTheResidual) {
  const auto csv = rows_of(projection_study_of({}), "projection.csv");
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "broken_promises"), "0") << row;
    if (csv.at(row, "residual_bound").empty()) {
      EXPECT_EQ(csv.at(row, "method"), "seed_004_scan");
      continue;
    }
    EXPECT_LE(run::number_at(csv, row, "max_residual"), run::number_at(csv, row, "residual_bound")) << row;
  }
}

TEST(ProjectionStudy, AResidualAboveItsBoundBreaksAPromise) {
  const std::vector<double> point{1, 2};
  ProjectionProblem::Drawn line{{2, 1, {0, 0, 4, 0}, point, {}}, {}};
  line.exact = reference::projection({Form::bernstein, 2, 1, line.placed.points}, point);
  const auto& kernel = ProjectionProblem::kernels(2).front();
  const auto broken = [&](const FootPoint& foot) {
    ProjectionErrors errors;
    ProjectionProblem::judge(kernel, line, 0, foot, 7, errors);
    return errors.broken_promises.count;
  };
  EXPECT_EQ(broken({0.25, 2, 2, true}), 0U);
  EXPECT_EQ(broken({0.25 + 0x1p-45, 2, 2, true}), 1U);  // the distance is right to all digits
  EXPECT_EQ(broken({0.25 + 0x1p-45, 2, 2, false}), 0U);
}

TEST(ProjectionStudy, SeesWhatScanningMisses) {
  const auto csv = rows_of(projection_study_of({"scan_bisect"}), "projection.csv");
  double missed = 0;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    missed += run::number_at(csv, row, "missed");
    EXPECT_EQ(csv.at(row, "missed") == "0", run::number_at(csv, row, "max_error") < 0x1p-20) << row;
  }
  EXPECT_GT(missed, 0);
}

TEST(ProjectionStudy, MethodsThatAreNotBitStableHaveAFileOfTheirOwn) {
  auto study = projection_study_of({"quintic_*"});
  study.degree = {2};
  study.trials = 3;
  const auto csv = rows_of(study, "projection_unstable.csv");
  std::map<std::string, std::string> status;
  for (std::size_t row = 0; row < csv.row_count(); ++row) status[csv.at(row, "method")] = csv.at(row, "status");
  EXPECT_EQ(status, (std::map<std::string, std::string>{{"quintic_companion", "ok"},
                                                        {"quintic_seed_002", "degree_unsupported"}}));
}

}  // namespace
}  // namespace bezierbench::studies
