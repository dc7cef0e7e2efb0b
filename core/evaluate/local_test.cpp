// SPDX-License-Identifier: MIT
// Methods about the nearer end, on curves that are small beside their distance from the origin.
#include "core/evaluate/local.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/bound/locality.hpp"
#include "core/convert/differences.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"
#include "core/evaluate/methods/local_or_bernstein.hpp"

namespace bezierbench {
namespace {

template <class E, class Scalar>
Scalar point(const std::vector<Scalar>& coordinates, Scalar t) {
  Curve<Form::bernstein, Scalar, 1> curve(static_cast<int>(coordinates.size()) - 1);
  for (std::size_t i = 0; i < coordinates.size(); ++i) curve(0, static_cast<int>(i)) = coordinates[i];
  return E::evaluate(E::prepare(curve), t)[0];
}

template <class E>
class LocalMethod : public testing::Test {};
using LocalMethods = testing::Types<Local<DeCasteljau>, Local<HornerBernsteinFma>, LocalOrBernstein::Plain,
                                    LocalOrBernstein::Corrected, LocalOrBernstein>;
TYPED_TEST_SUITE(LocalMethod, LocalMethods);

/// p(t) = 2^52 + 16 t^2 where all numbers are integers.
TYPED_TEST(LocalMethod, RoundsOnceOnAParabolaOfIntegers) {
  const std::vector<double> parabola{0x1p52, 0x1p52, 0x1p52 + 16};
  EXPECT_EQ((point<TypeParam>(parabola, 0.0625)), 0x1p52);        // 0.0625
  EXPECT_EQ((point<TypeParam>(parabola, 0.40625)), 0x1p52 + 3);   // 2.640625
  EXPECT_EQ((point<TypeParam>(parabola, 0.875)), 0x1p52 + 12);    // 12.25
  EXPECT_EQ((point<TypeParam>(parabola, 0.96875)), 0x1p52 + 15);  // 15.015625
  EXPECT_EQ((point<TypeParam>(parabola, 1.0)), 0x1p52 + 16);
}

/// p(t) = 8 + 3t 2^-20 at the numbers nearest to 1/3 and 2/3, where the spacing of float is 2^-20.
TYPED_TEST(LocalMethod, MeetsALineInFloat) {
  const std::vector<float> line{8, 8 + 0x1p-20F, 8 + 0x1p-19F, 8 + 0x1.8p-19F};
  EXPECT_EQ((point<TypeParam>(line, 1 / 3.0F)), 8 + 0x1p-20F);
  EXPECT_EQ((point<TypeParam>(line, 2 / 3.0F)), 8 + 0x1p-19F);
}

TEST(Locality, IsThatOfPowerCoefficientsAboutTheEnds) {
  // About the start 2 t + t^2, about the end -4 t + t^2: 1 + 1/4 and 2 + 1/4.
  const std::array<double, 3> quadratic{100, 101, 103};
  EXPECT_EQ(locality(2, [&](int i) { return quadratic[static_cast<std::size_t>(i)]; }), 2.25 / 103);
  EXPECT_EQ(locality(2, [](int) { return 0.0; }), 0);
}

/// (0, 7, 0) has q = (14, -14) about both ends: k = (7 + 7/2) / 7 = 3/2. (-1, 1, -1) has k = 2 + 1, (1, 3, 1) 3/3.
TEST(LocalOrBernstein, ChoosesByAxis) {
  const auto choice = [](const std::vector<double>& coordinates) {
    Curve<Form::bernstein, double, 1> curve(static_cast<int>(coordinates.size()) - 1);
    for (std::size_t i = 0; i < coordinates.size(); ++i) curve(0, static_cast<int>(i)) = coordinates[i];
    return LocalOrBernstein::prepare(curve).choice(0, 0);
  };
  EXPECT_EQ(choice({100, 101, 103}), 1);
  EXPECT_EQ(choice({3, 4, 6}), 1);  // 2.25 / 6, at most 1/2
  EXPECT_EQ(choice({2, 3, 5}), 1);  // 2.25 / 5
  EXPECT_EQ(choice({1, 2, 4}), 2);  // 2.25 / 4
  EXPECT_EQ(choice({0, 7, 0}), 2);
  EXPECT_EQ(choice({-1, 1, -1}), 0);
  EXPECT_EQ(choice({0, 0, 0}), 1);
  EXPECT_EQ(choice({1, 3, 1}), 2);
  EXPECT_EQ(choice({1e308, -1e308, 1e308}), 0);
}

/// The bounds are those of a curve as it is given: the error of a conversion is as large as p~ of a local curve, which
/// is more than the bound of its local form allows.
TEST(LocalOrBernstein, HasNoBoundAfterAConversion) {
  std::size_t paths = 0;
  for (const auto& kernel : kernels<double>(1)) {
    if (kernel.evaluator != &LocalOrBernstein::info || kernel.conversion == nullptr) continue;
    ++paths;
    EXPECT_FALSE(kernel.info->bound) << kernel.info->id;
  }
  EXPECT_GE(paths, 4U);
}

}  // namespace
}  // namespace bezierbench
