// SPDX-License-Identifier: MIT
// Properties of every method for subdivision, and known results.
#include "core/subdivide/roster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <set>
#include <vector>

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
  EXPECT_EQ(&info, split_kernels(1)[GetParam()].info);
  ASSERT_NE(kernel().bound, nullptr);
  EXPECT_THAT(std::string(info.promise), testing::EndsWith(kernel().bound->text));
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
                           const auto& method = *split_kernels(1)[parameter.param].info;
                           return std::string(method.id) + "_" + std::string(name(method.form));
                         });

TEST(SplitRoster, HasNoTwoMethodsOfOneName) {
  std::set<std::pair<std::string_view, Form>> seen;
  for (const auto& kernel : split_kernels(1)) EXPECT_TRUE(seen.emplace(kernel.info->id, kernel.info->form).second);
}

namespace mp = boost::multiprecision;
using Rational = mp::number<mp::cpp_rational_backend, mp::et_off>;
constexpr int degree = 6;

/// sum c_j C(n,j) s^j (1-s)^(n-j), summed term by term.
Rational bernstein(const std::vector<Rational>& c, const Rational& s) {
  Rational sum = 0;
  Rational binomial = 1;
  const int n = static_cast<int>(c.size()) - 1;
  for (int j = 0; j <= n; ++j) {
    Rational term = binomial * c[static_cast<std::size_t>(j)];
    for (int k = 0; k < n; ++k) term *= k < j ? s : Rational(1 - s);
    sum += term;
    binomial = binomial * (n - j) / (j + 1);
  }
  return sum;
}

/// The numerator and the denominator of a curve of dimension 1, as polynomials in Bernstein form.
std::vector<Rational> numerator(const Curve<Form::bernstein, Rational, 1, degree>& curve) {
  std::vector<Rational> c;
  for (int i = 0; i <= degree; ++i) c.push_back(curve(0, i));
  return c;
}
std::vector<Rational> denominator(const Curve<Form::bernstein, Rational, 1, degree>& /*curve*/) {
  return std::vector<Rational>(degree + 1, 1);
}
std::vector<Rational> numerator(const Curve<Form::rational, Rational, 1, degree>& curve) {
  std::vector<Rational> c;
  for (int i = 0; i <= degree; ++i) c.push_back(curve.weights[i] * curve.points(0, i));
  return c;
}
std::vector<Rational> denominator(const Curve<Form::rational, Rational, 1, degree>& curve) {
  std::vector<Rational> c;
  for (int i = 0; i <= degree; ++i) c.push_back(curve.weights[i]);
  return c;
}

void set(Curve<Form::bernstein, Rational, 1, degree>& curve, int number) {
  for (int i = 0; i <= degree; ++i)
    curve(0, i) = Rational((7 * i * i - 11 * i * number + 3) % 17, 1 + (i + number) % 5);
}
void set(Curve<Form::rational, Rational, 1, degree>& curve, int number) {
  set(curve.points, number);
  for (int i = 0; i <= degree; ++i) curve.weights[i] = Rational(1 + (5 * i + number) % 7, 2 + i % 3);
}

/// Expects left(s) = whole(s t) and right(s) = whole(t + s (1-t)) at n + 1 places, which determine polynomials of
/// degree n.
void expect_halves(const std::vector<Rational>& whole, const std::vector<Rational>& left,
                   const std::vector<Rational>& right, const Rational& t, std::string_view id) {
  for (int k = 0; k <= degree; ++k) {
    const Rational s(k, 3);
    EXPECT_EQ(bernstein(left, s), bernstein(whole, s * t)) << id << " t " << t;
    EXPECT_EQ(bernstein(right, s), bernstein(whole, t + s * (1 - t))) << id << " t " << t;
  }
}

template <SplitMethod M>
void expect_exact() {
  // two of these are outside [0,1], chosen such that no weight of a half is 0
  for (int number = 1; number <= 4; ++number)
    for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1, 2), Rational(5, 7), Rational(1),
                              Rational(-10, 97), Rational(108, 97)}) {
      Curve<M::info.form, Rational, 1, degree> curve(degree);
      set(curve, number);
      const auto halves = M::split(curve, t);
      expect_halves(numerator(curve), numerator(halves.left), numerator(halves.right), t, M::info.id);
      expect_halves(denominator(curve), denominator(halves.left), denominator(halves.right), t, M::info.id);
    }
}

template <class... Ms>
void expect_all_exact(TypeList<Ms...> /*methods*/) {
  (expect_exact<Ms>(), ...);
}

TEST(SplitAlgebra, EveryMethodGivesTheHalvesWhenNothingRounds) { expect_all_exact(SplitMethods{}); }

}  // namespace

}  // namespace bezierbench
