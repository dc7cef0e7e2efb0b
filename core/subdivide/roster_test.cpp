// SPDX-License-Identifier: MIT
// Properties of every method for subdivision, and known results.
#include "core/subdivide/roster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/subdivide/split_test.hpp"

namespace bezierbench {
namespace {

class Split : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] const SplitKernel& kernel(int dimension = 2) const { return split_kernels(dimension)[GetParam()]; }
  [[nodiscard]] Form form() const { return kernel().info->form; }
};

TEST_P(Split, StatesWhatItIs) {
  const auto& info = *kernel().info;
  EXPECT_THAT(std::string(info.id), testing::MatchesRegex("[a-z_]+_split"));
  EXPECT_FALSE(info.label.empty());
  EXPECT_FALSE(info.citation.empty());
  EXPECT_FALSE(info.flops.empty());
  EXPECT_EQ(info.problem, Problem::subdivision);
  EXPECT_EQ(&info, split_infos()[GetParam()]);
  ASSERT_NE(kernel().bound, nullptr);
  EXPECT_THAT(std::string(info.promise), testing::EndsWith(kernel().bound->text));
}

/// The matrices of the halves of a cubic at t = 1/2 (Joy, "A Matrix Formulation of the Cubic Bezier Curve", CAGD notes
/// of UC Davis). Splitting a curve with one control point 1 and all others 0 gives a column. Nothing is rounded.
TEST_P(Split, GivesTheHalvingMatricesOfACubic) {
  if (form() != Form::bernstein) return;  // the matrices apply to curves without weights
  const std::vector<std::vector<double>> left{
      {1, 0, 0, 0}, {0.5, 0.5, 0, 0}, {0.25, 0.5, 0.25, 0}, {0.125, 0.375, 0.375, 0.125}};
  const std::vector<std::vector<double>> right{
      {0.125, 0.375, 0.375, 0.125}, {0, 0.25, 0.5, 0.25}, {0, 0, 0.5, 0.5}, {0, 0, 0, 1}};
  for (std::size_t j = 0; j < 4; ++j) {
    std::vector<double> unit(4, 0.0);
    unit[j] = 1;
    const auto halves = split(kernel(1), {Form::bernstein, 1, 3, unit}, 0.5);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(halves.left[i], left[i][j]);
      EXPECT_EQ(halves.right[i], right[i][j]);
    }
  }
}

/// The blossom of t^n is the product of its arguments ([Ramshaw 1987]): left is 0, .., 0, t^n, and right is t^n, .., t,
/// 1.
TEST_P(Split, GivesTheHalvesOfAPower) {
  if (form() != Form::bernstein) return;
  for (const double t : {0.25, 0.5, 0.75}) {  // all powers are exact
    const std::vector<double> power{0, 0, 0, 0, 0, 1};
    const auto halves = split(kernel(1), {Form::bernstein, 1, 5, power}, t);
    EXPECT_THAT(halves.left, testing::ElementsAre(0, 0, 0, 0, 0, t * t * t * t * t));
    EXPECT_THAT(halves.right, testing::ElementsAre(t * t * t * t * t, t * t * t * t, t * t * t, t * t, t, 1));
  }
}

/// The quarter circle with weights 1, 1, 2 (Farin, Curves and Surfaces for CAGD, 5th ed., conics) becomes two arcs that
/// meet in (3/5, 4/5). The tangent 3x + 4y = 5 there meets those at the ends in (1, 1/2) and (1/3, 1). Computed by
/// hand, the homogeneous points are (1,0) (1,1/2) (3/4,1) and (3/4,1) (1/2,3/2) (0,2), the weights 1, 1, 5/4 and 5/4,
/// 3/2, 2.
TEST_P(Split, GivesTheArcsOfAQuarterCircle) {
  if (form() != Form::rational) return;
  const std::vector<double> c{1, 0, 1, 1, 0, 1};
  const std::vector<double> w{1, 1, 2};
  const auto halves = split(kernel(), {Form::rational, 2, 2, c, w}, 0.5);
  EXPECT_THAT(halves.left, testing::ElementsAre(1, 0, 1, 1, 0.5, 1, 0.6, 0.8, 1.25));
  EXPECT_THAT(halves.right, testing::ElementsAre(0.6, 0.8, 1.25, 1.0 / 3, 1, 1.5, 0, 1, 2));
}

TEST_P(Split, ScalesWithPowersOfTwo) {
  Inputs inputs(4);
  for (const int degree : {0, 1, 3, 8, 20})
    for (const double t : split_parameters) {
      const auto c = inputs.coefficients(degree, 2);
      auto scaled = c;
      for (double& value : scaled) value *= -0x1p+60;
      const auto halves = split(kernel(), view(form(), 2, degree, c), t);
      const auto of_scaled = split(kernel(), view(form(), 2, degree, scaled), t);
      const auto columns = static_cast<std::size_t>(split_columns(form(), 2));
      for (std::size_t k = 0; k < halves.left.size(); ++k) {
        const double factor = k % columns == 2 ? 1 : -0x1p+60;
        EXPECT_EQ(of_scaled.left[k], factor * halves.left[k]) << "degree " << degree << " t " << t;
        EXPECT_EQ(of_scaled.right[k], factor * halves.right[k]) << "degree " << degree << " t " << t;
      }
    }
}

TEST_P(Split, TreatsAxesAlike) {
  Inputs inputs(5);
  for (const int degree : {1, 4, 20})
    for (const double t : split_parameters) {
      const auto c = inputs.coefficients(degree, 3);
      const auto in_space = split(kernel(3), view(form(), 3, degree, c), t);
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> own;
        for (int i = 0; i <= degree; ++i) own.push_back(c[static_cast<std::size_t>(3 * i + axis)]);
        const auto on_line = split(kernel(1), view(form(), 1, degree, own), t);
        for (int i = 0; i <= degree; ++i) {
          const auto there = static_cast<std::size_t>(i * split_columns(form(), 3) + axis);
          const auto here = static_cast<std::size_t>(i * split_columns(form(), 1));
          EXPECT_EQ(on_line.left[here], in_space.left[there]) << "degree " << degree << " t " << t;
          EXPECT_EQ(on_line.right[here], in_space.right[there]) << "degree " << degree << " t " << t;
        }
      }
    }
}

/// The tolerance for relations between two splits of curves in [-4, 4], which hold up to rounding.
double tolerance(int degree) { return 64 * (degree + 1) * 0x1p-53 * 4; }

TEST_P(Split, IsAffinelyInvariant) {
  Inputs inputs(6);
  for (const int degree : {0, 1, 2, 5, 20})
    for (const double t : split_parameters) {
      const auto c = inputs.coefficients(degree, 2);
      std::vector<double> image(c.size());
      for (std::size_t k = 0; k < c.size(); k += 2) {
        image[k] = 2 * c[k] - c[k + 1] + 1;
        image[k + 1] = 0.5 * c[k] + c[k + 1] - 1;
      }
      const auto halves = split(kernel(), view(form(), 2, degree, c), t);
      const auto of_image = split(kernel(), view(form(), 2, degree, image), t);
      const auto columns = static_cast<std::size_t>(split_columns(form(), 2));
      for (const auto& [p, q] : {std::pair(&halves.left, &of_image.left), std::pair(&halves.right, &of_image.right)})
        for (std::size_t k = 0; k < p->size(); k += columns) {
          EXPECT_NEAR((*q)[k], 2 * (*p)[k] - (*p)[k + 1] + 1, tolerance(degree));
          EXPECT_NEAR((*q)[k + 1], 0.5 * (*p)[k] + (*p)[k + 1] - 1, tolerance(degree));
        }
    }
}

TEST_P(Split, ReversesWithItsControlPoints) {
  Inputs inputs(7);
  for (const int degree : {0, 1, 2, 5, 20}) {
    const Drawn drawn(form(), degree, inputs);
    const double t = 0.5 + 0.5 * inputs.unit();  // 1 - t is exact
    const auto p = split(kernel(1), drawn.curve(), t);
    const auto q = reversed(split(kernel(1), drawn.reversed().curve(), 1 - t), split_columns(form(), 1));
    for (std::size_t k = 0; k < p.left.size(); ++k) {
      EXPECT_NEAR(p.left[k], q.left[k], tolerance(degree)) << degree;
      EXPECT_NEAR(p.right[k], q.right[k], tolerance(degree)) << degree;
    }
  }
}

/// The blossom repeats the triangle for each control point, with the same roundings.
TEST(BlossomSplit, GivesTheBitsOfDeCasteljau) {
  Inputs inputs(9);
  const auto find = [](Form form, std::string_view id) {
    return *std::ranges::find_if(split_kernels(1), [&](const SplitKernel& kernel) {
      return kernel.info->form == form && kernel.info->id == id;
    });
  };
  for (const Form form : {Form::bernstein, Form::rational})
    for (const int degree : {0, 1, 4, 20})
      for (const double t : split_parameters) {
        const Drawn drawn(form, degree, inputs);
        const auto blossom = split(find(form, BlossomSplit::info.id), drawn.curve(), t);
        const auto triangle = split(find(form, DeCasteljauSplit::info.id), drawn.curve(), t);
        EXPECT_TRUE(same_bits(blossom.left, triangle.left)) << degree << " " << t;
        EXPECT_TRUE(same_bits(blossom.right, triangle.right)) << degree << " " << t;
      }
}

/// At t = 1 the true point is b_1 = 2^-60, and p~ is the same. The method computes 1 + (2^-60 - 1) = 0. This error is
/// 2^53 u p~, but less than u max |b_j|.
TEST(LerpSplit, MayMissThePointByFarMoreThanUTimesPTilde) {
  const std::vector<double> c{1, 0x1p-60};
  const CurveView<double> curve{Form::bernstein, 1, 1, c};
  const SplitTruth truth(curve, 1);
  const double at_one = split(split_kernels(1)[1], curve, 1).right[0];
  ASSERT_EQ(split_kernels(1)[1].info->id, LerpSplit::info.id);
  EXPECT_EQ(at_one, 0);
  const auto [error, bound] = truth.judge(LerpSplit::bound, split_double, false, 0, 0, at_one);
  EXPECT_EQ(error, 0x1p-60);
  EXPECT_LE(error, bound);
}

INSTANTIATE_TEST_SUITE_P(Roster, Split, testing::Range<std::size_t>(0, split_kernels(2).size()),
                         [](const auto& parameter) {
                           const auto& method = *split_infos()[parameter.param];
                           return std::string(method.id) + "_" + std::string(name(method.form));
                         });

TEST(SplitRoster, HasNoTwoMethodsOfOneName) {
  std::set<std::pair<std::string_view, Form>> seen;
  for (const auto* info : split_infos()) EXPECT_TRUE(seen.emplace(info->id, info->form).second);
}

}  // namespace
}  // namespace bezierbench
