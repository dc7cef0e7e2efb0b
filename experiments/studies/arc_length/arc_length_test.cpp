// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/failure.hpp"
#include "experiments/studies/length_study_test.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {
namespace {

/// Small whole numbers as coordinates give cusps, curves that turn back and curves that are a point.
suite::Study small_arc_length_study() { return small_length_study("arc_length", {"continuous", "integer"}); }

TEST(ArcLengthStudy, OrderAndInterruptionsChangeNoByteAndPromisesAreKept) {
  const auto tables = run::expect_order_changes_nothing(make_job, small_arc_length_study());
  const auto csv = bundle::parse_csv(tables.at("arc_length.csv"), "arc_length.csv");
  ASSERT_EQ(csv.row_count(), 2U * 2 * 2 * 4);
  EXPECT_EQ(make_job(small_arc_length_study(), {1})->extent().rows, csv.row_count());
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

}  // namespace
}  // namespace bezierbench::studies
