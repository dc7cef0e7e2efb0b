// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "experiments/studies/hard_cases/hard_value.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

using reference::exactly;

double double_distance(const reference::Rational& value) {
  return round_to(reference::binary64, boundary_distance(reference::binary64, value));
}

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

// The midpoints next to 1 are 1 + 2^-53 and 1 - 2^-54.
TEST(BoundaryDistance, IsToTheNearestMidpoint) {
  EXPECT_EQ(double_distance(exactly(1.5)), 0.5);
  EXPECT_EQ(double_distance(exactly(-1.5)), 0.5);
  EXPECT_EQ(double_distance(exactly(1)), 0.25);
  EXPECT_EQ(double_distance(exactly(1) + exactly(0x1p-53)), 0);
  EXPECT_EQ(double_distance(exactly(1) + exactly(0x1p-54)), 0.25);
  EXPECT_EQ(double_distance(exactly(1) - exactly(0x1p-54)), 0);
  EXPECT_EQ(double_distance(exactly(3) + exactly(0x1p-53)), 0.25);
}

TEST(BoundaryDistance, KnowsTheEndsOfTheFormat) {
  EXPECT_EQ(double_distance({}), 0.5);
  EXPECT_EQ(double_distance(exactly(smallest)), 0.5);
  EXPECT_EQ(double_distance(exactly(smallest) * exactly(0.5)), 0);
  EXPECT_EQ(double_distance(exactly(smallest) * exactly(0.75)), 0.25);
  EXPECT_EQ(double_distance(exactly(0x1p-1022)), 0.5);  // subnormal numbers are as far apart
  EXPECT_EQ(double_distance(exactly(largest)), 0.5);
  EXPECT_EQ(double_distance(exactly(largest) + exactly(0x1p970)), 0);
  EXPECT_EQ(double_distance(exactly(largest) + exactly(0x1p971)), 0.5);
  EXPECT_EQ(significant(boundary_distance(reference::binary64, exactly(largest) + exactly(largest)), 20),
            "9.0071992547409905e+15");
}

TEST(Significant, RoundsOnce) {
  EXPECT_EQ(significant({}, 5), "0");
  EXPECT_EQ(significant(exactly(1), 5), "1");
  EXPECT_EQ(significant(exactly(-1.25), 40), "-1.25");
  EXPECT_EQ(significant(exactly(0.1), 40), "1.000000000000000055511151231257827021182e-1");
  EXPECT_EQ(significant(exactly(99999.5), 5), "1e+5");
  EXPECT_EQ(significant(exactly(12345.5), 5), "1.2346e+4");
  EXPECT_EQ(significant(exactly(12344.5), 5), "1.2344e+4");
  EXPECT_EQ(significant(exactly(1000), 1), "1e+3");
  EXPECT_EQ(significant(exactly(999), 3), "9.99e+2");
  EXPECT_EQ(significant(exactly(smallest), 3), "4.94e-324");
  EXPECT_EQ(significant(exactly(smallest) * exactly(smallest), 3), "2.44e-647");
  EXPECT_EQ(significant(exactly(largest), 5), "1.7977e+308");
}

suite::Study small_hard_cases_study(Form form) {
  auto study = small_study("hard_cases");
  study.form = form;
  study.kept = 3;
  study.scalar = {suite::ScalarKind::float64, suite::ScalarKind::float32};
  study.trials = 2100;  // two blocks, the last one short
  return study;
}

TEST(HardCasesStudy, OrderAndInterruptionsChangeNoByte) {
  for (const auto form : {Form::bernstein, Form::power}) {
    const auto files = run::expect_order_changes_nothing(make_job, small_hard_cases_study(form));
    EXPECT_LE(bundle::parse_csv(files.at("hard_cases.csv"), "hard_cases.csv").row_count(),
              make_job(small_hard_cases_study(form), {1})->extent().rows);
  }
}

}  // namespace
}  // namespace bezierbench::studies
