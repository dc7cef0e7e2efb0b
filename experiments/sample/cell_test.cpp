// SPDX-License-Identifier: MIT
#include "experiments/sample/cell.hpp"

#include <gtest/gtest.h>

#include <set>

namespace bezierbench::sample {
namespace {

// Known answers of FNV-1a, 64 bits (Fowler, Noll, Vo; RFC 9923).
TEST(Key, IsFnv1a) {
  EXPECT_EQ(key(std::string_view("")), 0xcbf29ce484222325U);
  EXPECT_EQ(key(std::string_view("a")), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(key(std::string_view("foobar")), 0x85944171f73967e8U);
}

TEST(Cell, HasACanonicalText) {
  const Cell cell{Form::power, 2, 4, 1e6, {0.25, 1}, "dyadic"};
  const std::string text =
      "curve=polynomial;dimension=2;degree=4;coordinate_range=1e+06;t_interval=0.25:1;generator=dyadic";
  EXPECT_EQ(canonical(cell), text);
  EXPECT_EQ(key(cell), key(std::string_view(text)));
}

TEST(Cell, CellsAreTheCrossProductInOrder) {
  suite::Study study;
  study.form = Form::power;
  study.dimension = {2, 3};
  study.degree = {4, 8};
  study.coordinate_range = {1, 10};
  study.t_interval = {{0, 1}, {0, 0.2}};
  study.generator = {"report", "continuous"};
  const std::vector<Cell> all = cells(study);
  ASSERT_EQ(all.size(), 32U);
  const suite::Interval unit{0, 1};
  const suite::Interval fifth{0, 0.2};
  EXPECT_EQ(all[0], (Cell{Form::power, 2, 4, 1, unit, "report"}));
  EXPECT_EQ(all[1], (Cell{Form::power, 2, 4, 1, unit, "continuous"}));
  EXPECT_EQ(all[2], (Cell{Form::power, 2, 4, 1, fifth, "report"}));
  EXPECT_EQ(all[4], (Cell{Form::power, 2, 4, 10, unit, "report"}));
  EXPECT_EQ(all[8], (Cell{Form::power, 2, 8, 1, unit, "report"}));
  EXPECT_EQ(all[16], (Cell{Form::power, 3, 4, 1, unit, "report"}));
  std::set<std::uint64_t> keys;
  for (const Cell& cell : all) keys.insert(key(cell));
  EXPECT_EQ(keys.size(), all.size());
}

}  // namespace
}  // namespace bezierbench::sample
