// SPDX-License-Identifier: MIT
#include "experiments/studies/arc_length.hpp"

#include <gtest/gtest.h>

#include "experiments/studies/length_study_test.hpp"

namespace bezierbench::studies {
namespace {

/// Small whole numbers: cusps, turns, points.
suite::Study small_study() { return small_length_study(suite::Kind::arc_length, {"continuous", "integer"}); }

TEST(ArcLengthStudy, OrderAndInterruptionsChangeNoByteAndPromisesAreKept) {
  const auto tables = expect_order_changes_nothing(arc_length_job, small_study());
  const auto csv = bundle::parse_csv(tables.at("arc_length.csv"), "arc_length.csv");
  ASSERT_EQ(csv.row_count(), 2U * 2 * 2 * 4);
  EXPECT_EQ(arc_length_job(small_study(), {1})->extent().rows, csv.row_count());
  for (std::size_t row = 0; row < csv.row_count(); ++row) expect_kept(csv, row);
}

TEST(ArcLengthStudy, RefusesWhatItCannotDo) { expect_refusals(arc_length_job, small_study()); }

}  // namespace
}  // namespace bezierbench::studies
