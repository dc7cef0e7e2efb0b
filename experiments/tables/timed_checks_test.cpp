// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "experiments/metric/tally.hpp"
#include "experiments/tables/tables.hpp"

namespace bezierbench::tables {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Row in_cell(const std::string& file, double range, const std::string& scalar) {
  return Row(file)
      .set("form", "bernstein")
      .set("method", "m")
      .set("scalar", scalar)
      .set("dimension", 2)
      .set("degree", 5)
      .set("coordinate_range", range)
      .set("t_min", 0)
      .set("t_max", 1)
      .set("generator", "continuous");
}

void observe(Tables& tables, const std::string& study, double error_u, double range = 1,
             const std::string& scalar = "double") {
  tables.add(in_cell("accuracy.csv", range, scalar)
                 .set("study", study)
                 .set("baseline", "exact")
                 .set("status", "ok")
                 .set("non_finite", 0)
                 .set("max_error_u", error_u));
}

void time_with(Tables& tables, std::optional<double> error_u, const std::string& scalar = "double",
               const std::string& checked = "yes") {
  tables.add(in_cell("timing.csv", 1, scalar)
                 .set("study", "t")
                 .set("median_ns", 1)
                 .set("max_error_u", error_u)
                 .set("checked", checked));
}

std::string found(Tables& tables, std::string_view column, std::size_t row = 0) {
  check_timed_errors(tables);
  return text(tables.table("timing.csv").rows().at(row).field(column));
}

TEST(TimedChecks, HoldAMethodWithoutABoundToWhatWasObservedInItsCell) {
  for (const auto& [error_u, checked] : {std::pair(64, "yes"), std::pair(65, "no")}) {
    Tables tables;
    observe(tables, "s", 3);
    observe(tables, "other", 4);
    observe(tables, "of_another_range", 1e6, 2);
    observe(tables, "in_float", 1e6, 1, "float");
    time_with(tables, error_u);
    EXPECT_EQ(found(tables, "allowed_error_u"), "64") << "16 times 4";
    EXPECT_EQ(found(tables, "checked"), checked);
  }
}

TEST(TimedChecks, HoldItToHalfOfTheDigitsWhereNothingWasObserved) {
  Tables tables;
  observe(tables, "s", 1, 2);
  time_with(tables, 94906265);
  time_with(tables, 94906267);
  time_with(tables, 4095, "float");
  time_with(tables, 4097, "float");
  for (const std::size_t row : {0U, 1U, 2U, 3U}) EXPECT_EQ(found(tables, "checked", row), row % 2 == 0 ? "yes" : "no");
}

TEST(TimedChecks, TakeNoInfiniteErrorForALeave) {
  Tables tables;
  observe(tables, "s", infinite);
  time_with(tables, 1e9);
  EXPECT_EQ(found(tables, "checked"), "no");
}

TEST(TimedChecks, LeaveTheOtherRowsAsTheyAre) {
  Tables tables;
  time_with(tables, std::nullopt, "double", "no");
  time_with(tables, 1, "double", "no");
  time_with(tables, std::nullopt);
  const auto before = tables.table("timing.csv").row_count();
  EXPECT_EQ(found(tables, "checked", 0), "no");
  EXPECT_EQ(found(tables, "allowed_error_u", 0), "") << "a bound is proved";
  EXPECT_EQ(found(tables, "checked", 1), "no") << "the output changed";
  EXPECT_EQ(found(tables, "checked", 2), "yes");
  EXPECT_EQ(tables.table("timing.csv").row_count(), before);
}

TEST(TimedChecks, AllowARoundingWhereNoneWasObserved) { EXPECT_EQ(metric::allowed_error_u(0, 0x1p-53), 16); }

}  // namespace
}  // namespace bezierbench::tables
