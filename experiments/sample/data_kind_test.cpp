// SPDX-License-Identifier: MIT
#include "experiments/sample/data_kind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bezierbench::sample {
namespace {

std::vector<double> made(std::string_view id, DataSource source) {
  return std::ranges::find_if(data_kinds(), [id](const DataKind& kind) { return kind.id == id; })
      ->make(std::move(source));
}

const DataSource parabola{2, 2, {0, 0, 1, 2, 2, 0}, {8, 0, -8, 8, 0, 0, 8, 0, 4, 0}};  // (2t, 4t(1-t)), five points

TEST(DataKinds, AreMadeOfTheCurve) {
  using testing::ElementsAre;
  EXPECT_THAT(made("samples", parabola), ElementsAre(0, 0, 0.5, 0.75, 1, 1, 1.5, 0.75, 2, 0));
  // t = 0, 0.2, 0.5, 0.8, 1
  EXPECT_THAT(
      made("uneven", parabola),
      testing::Pointwise(testing::DoubleNear(1e-15), std::vector<double>{0, 0, 0.4, 0.64, 1, 1, 1.6, 0.64, 2, 0}));
  EXPECT_THAT(made("noisy", parabola),
              ElementsAre(0x1p-7, 0, 0.5 - 0x1p-7, 0.75 + 0x1p-7, 1, 1, 1.5 + 0x1p-7, 0.75, 2 + 0x1p-8, 0));
  EXPECT_THAT(made("polyline", parabola), ElementsAre(0, 0, 0.5, 1, 1, 2, 1.5, 1, 2, 0));
  EXPECT_THAT(made("closed", parabola), ElementsAre(0, 0, 0.375, 0.75, 0.5, 1, 0.375, 0.75, 0, 0));
}

TEST(DataKinds, PolylineKeepsItsVertices) {
  for (std::size_t count = 2; count < 30; ++count) {
    const auto data = made("polyline", {1, 4, {0, 1, 3, -4, 7}, std::vector<double>(count, 0.0)});
    ASSERT_EQ(data.size(), count);
    for (const double vertex : {0, 1, 3, -4, 7}) {
      if (count >= 5) {
        EXPECT_THAT(data, testing::Contains(vertex)) << count;
      }
    }
  }
}

TEST(DataKinds, AClosedCubicIsALoop) {
  const auto data = made("closed", {2, 3, {0, 0, 6, 0, 0, 6, 9, 9}, std::vector<double>(10, 0.0)});
  EXPECT_THAT(data, testing::ElementsAre(0, 0, 2.53125, 0.84375, 2.25, 2.25, 0.84375, 2.53125, 0, 0));
}

TEST(DataKinds, OfACellAreDrawnFromItsCurve) {
  Cell cell;
  cell.degree = 3;
  const Sampler sampler(1, "data", with_displacements(cell, 20));
  Trial drawn;
  sampler.draw(5, drawn);
  for (const auto& kind : data_kinds()) {
    const auto data = data_points(kind, sampler, cell, 5);
    ASSERT_EQ(data.size(), 40U) << kind.id;
    EXPECT_NEAR(data[0], drawn.coefficients[0], 0x1p-9) << kind.id;
  }
}

}  // namespace
}  // namespace bezierbench::sample
