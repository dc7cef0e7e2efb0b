// SPDX-License-Identifier: MIT
#include "experiments/studies/companion_rivals.hpp"

#include <gtest/gtest.h>

#include "experiments/failure.hpp"
#include "experiments/studies/timing.hpp"

namespace bezierbench::studies {
namespace {

suite::Study study_of(std::vector<std::string> methods, std::vector<double> tolerance) {
  suite::Study study;
  study.id = "race";
  study.kind = suite::Kind::timing;
  study.degree = {3};
  study.methods = std::move(methods);
  study.tolerance = std::move(tolerance);
  study.modes = {suite::Mode::one_shot};
  return study;
}

JudgedRivals rivals_of(const suite::Study& study) {
  const auto cell = sample::cells(study).front();
  const auto problem = timed_problem(study);
  return companion_rivals(timed_companions(study, problem, cell), problem, study, cell, 1);
}

TEST(CompanionRivals, ReproduceTheirResults) {
  for (const auto& study : {study_of({"gauss_legendre_adaptive", "adaptive_simpson38"}, {1e-6}),
                            study_of({"quintic_isolate", "scan_refine"}, {})}) {
    const auto [rivals, right] = rivals_of(study);
    ASSERT_EQ(rivals.size(), 2U);
    EXPECT_TRUE(right[0]);
    for (const auto& rival : rivals) {
      EXPECT_FALSE(rival.check()) << rival.name << ": nothing ran yet";
      rival.run();
      EXPECT_TRUE(rival.check()) << rival.name;
      EXPECT_FALSE(rival.check()) << rival.name << ": the results of the last run are spoilt";
    }
  }
}

TEST(CompanionRivals, AreToldFromThoseWhoseResultsAreWrong) {
  EXPECT_EQ(rivals_of(study_of({"gauss_legendre_24", "gauss_legendre_adaptive"}, {1e-10})).right,
            (std::vector<bool>{false, true}));
  EXPECT_EQ(rivals_of(study_of({"quintic_isolate", "quintic_seed_002"}, {})).right, (std::vector<bool>{true, false}));
}

TEST(CompanionRivals, AreOfTheProblemThatTheStudyNames) {
  EXPECT_EQ(timed_problem(study_of({"chord_sum"}, {})), Problem::arc_length);
  EXPECT_EQ(timed_problem(study_of({"scan_bisect"}, {})), Problem::projection);
  EXPECT_EQ(timed_problem(study_of({"de_casteljau"}, {})), Problem::evaluation);
  EXPECT_EQ(timed_problem(study_of({"*"}, {})), Problem::evaluation);
}

TEST(CompanionRivals, RefuseWhatIsNotTimed) {
  const auto refused = [](const suite::Study& study) { EXPECT_THROW(timing_job(study, {1}), Failure); };
  refused(study_of({"chord_sum"}, {}));
  refused(study_of({"chord_sum"}, {1e-3, 1e-6}));
  refused(study_of({"scan_bisect"}, {1e-3}));
  refused(study_of({"scan_bisect", "chord_sum"}, {}));
  refused(study_of({"c2_natural"}, {}));
  auto study = study_of({"scan_bisect"}, {});
  study.modes = {suite::Mode::one_shot, suite::Mode::point};
  refused(study);
  study = study_of({"scan_bisect"}, {});
  study.scalar = {suite::ScalarKind::float32};
  refused(study);
}

}  // namespace
}  // namespace bezierbench::studies
