// SPDX-License-Identifier: MIT
// Studies of arc length and of its inverse, which share their inputs and the meaning of a tolerance.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "experiments/studies/study_test.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

/// A small study of the kind.
suite::Study small_length_study(std::string_view id, std::vector<std::string> generators) {
  auto study = small_study(id);
  study.tolerance = {1e-3, 1e-9};
  study.degree = {3};
  study.coordinate_range = {1};
  study.t_interval = {{0, 1}, {0.25, 0.75}};
  study.generator = std::move(generators);
  study.trials = 20;
  return study;
}

/// Expects no broken promise and, where every trial converged, a largest error within the tolerance.
void expect_kept(const bundle::CsvDocument& csv, std::size_t row) {
  EXPECT_EQ(csv.at(row, "broken_promises"), "0");
  EXPECT_EQ(csv.at(row, "non_finite"), "0");
  const double tolerance = *number::parse_number(csv.at(row, "tolerance"));
  if (csv.at(row, "non_converged") == "0") {
    EXPECT_LE(*number::parse_number(csv.at(row, "max_relative")), tolerance * 1.001);
  }
}

/// Small whole numbers as coordinates give cusps, curves that turn back and curves that are a point.
suite::Study small_arc_length_study() { return small_length_study("arc_length", {"continuous", "integer"}); }

TEST(ArcLengthStudy, PromisesAreKept) {
  const auto csv = rows_of(small_arc_length_study(), "arc_length.csv");
  ASSERT_EQ(csv.row_count(), 2U * 2 * 2 * 6);
  for (std::size_t row = 0; row < csv.row_count(); ++row) expect_kept(csv, row);
}

/// (t - 3/4)^9, from 3/4 to the next double, is so short a curve that 70 digits do not suffice. The failure names the
/// trial.
TEST(ArcLengthStudy, SaysWhichTruthIsNotCertain) {
  auto study = small_arc_length_study();
  study.dimension = {1};
  study.degree = {9};
  study.generator = {"multiple_root"};
  study.t_interval = {{0.75, 0.75 + 0x1p-53}};
  const auto job = make_job(study, {1});
  try {
    static_cast<void>(job->run_block(0));
    FAIL() << "certain";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::usage);
    for (const char* needle :
         {"study small", "multiple_root", "trial 0", "not certain to 30 digits", "leave this cell out"})
      EXPECT_NE(std::string(failure.what()).find(needle), std::string::npos) << needle << ": " << failure.what();
  }
}

suite::Study small_inverse_arc_length_study() {
  auto study = small_length_study("inverse_arc_length", {"cusp", "integer"});
  study.t_interval = {{0.25, 0.75}};  // true parameters take longer than true lengths
  return study;
}

TEST(InverseArcLengthStudy, PromisesAreKept) {
  const auto csv = rows_of(small_inverse_arc_length_study(), "inverse_arc_length.csv");
  ASSERT_EQ(csv.row_count(), 2U * 2 * 4);
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    expect_kept(csv, row);
    EXPECT_LE(*number::parse_number(csv.at(row, "mean_iterations")),
              *number::parse_number(csv.at(row, "max_iterations")));
    if (csv.at(row, "method") == "bracketed_newton") {
      EXPECT_EQ(csv.at(row, "non_converged"), "0");
      EXPECT_EQ(csv.at(row, "outside"), "0");
    }
  }
}

/// The gaps are even at equal lengths and uneven at equal steps of t; the shares go from 0 to 1.
TEST(InverseArcLengthStudy, WritesOneCurveWithBothSpacings) {
  auto study = small_inverse_arc_length_study();
  study.trials = 1;
  const auto csv = rows_of(study, "spacing.csv");
  ASSERT_EQ(csv.row_count(), 201U + 21 + 21);
  double widest = 0;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "study"), "small");
    EXPECT_EQ(csv.at(row, "z"), "");
    if (csv.at(row, "spacing") == "outline") continue;
    if (csv.at(row, "index") == "0") {
      EXPECT_EQ(csv.at(row, "share"), "0");
      EXPECT_EQ(csv.at(row, "gap"), "");
      continue;
    }
    const double gap = *number::parse_number(csv.at(row, "gap"));
    if (csv.at(row, "spacing") == "arc_length") {
      EXPECT_NEAR(gap, 1, 1e-12);
      EXPECT_NEAR(*number::parse_number(csv.at(row, "share")), std::stod(csv.at(row, "index")) / 20, 1e-12);
    }
    if (csv.at(row, "spacing") == "parameter") widest = std::max(widest, gap);
  }
  EXPECT_GT(widest, 1.5);
}

}  // namespace
}  // namespace bezierbench::studies
