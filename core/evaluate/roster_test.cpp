// SPDX-License-Identifier: MIT
// What every method in the roster must do, whatever it is; a wrong one cannot pass.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>

#include "core/evaluate/evaluation_test.hpp"
#include "experiments/metric/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench {
namespace {

template <class Scalar>
bool supports(const Kernel<Scalar>& kernel, int degree) {
  return kernel.info->template supports<Scalar>(degree);
}

const std::vector<double> parameters{0, 1, 0.5, 0.3, 0x1p-30, 1 - 0x1p-53, 0.9, -0.25, 1.5};

/// Those at which the method has a value: outside [0,1] sums of weights may vanish, and some methods end there.
std::vector<double> parameters_for(const MethodInfo& info) {
  auto ts = parameters;
  if (info.form == Form::rational || info.unit_interval_only)
    std::erase_if(ts, [](double t) { return t < 0 || t > 1; });
  return ts;
}

class Method : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] const Kernel<double>& kernel(int dimension = 2) const { return kernels<double>(dimension)[GetParam()]; }
  [[nodiscard]] const Kernel<float>& float_kernel(int dimension = 2) const {
    return kernels<float>(dimension)[GetParam()];
  }
};

// Tests of what some methods state only: each runs for those, and says so by its names.
class BoundedMethod : public Method {};    ///< states a bound
class BernsteinMethod : public Method {};  ///< power coefficients have no mirror image
class StableMethod : public Method {};     ///< the bits of others belong to libm
class EndPointMethod : public Method {};   ///< native, in Bernstein form, with a bound in terms of p~

/// The highest power of n in a text such as "3d n(n+1)/2 + 1": factors n and factors in brackets that hold an n.
int power_of_n(std::string_view text) {
  int highest = 0;
  int power = 0;
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto letter = [&](std::size_t at) { return at < text.size() && std::isalpha(text[at]) != 0; };
    const bool in_word = letter(k + 1) || (k > 0 && letter(k - 1) && text[k - 1] != 'd');
    const bool n = text[k] == 'n' && !in_word;
    if (text[k] == '(') ++depth;
    if (text[k] == ')') --depth;
    if (n && (depth == 0 || text.substr(0, k).find_last_of("(n") == text.substr(0, k).rfind('('))) ++power;
    if (depth == 0 && (text[k] == ' ' || text[k] == ',')) power = 0;
    highest = std::max(highest, power);
  }
  return highest;
}

TEST(Roster, ReadsPowersOfN) {
  EXPECT_EQ(power_of_n("2dn + log2 n"), 1);
  EXPECT_EQ(power_of_n("n(5+3d) + 2, n + 1 of them divisions"), 1);
  EXPECT_EQ(power_of_n("3d n(n+1)/2 + 1"), 2);
  EXPECT_EQ(power_of_n("(n+1)(n+2)(3/2+d) per curve"), 2);
  EXPECT_EQ(power_of_n("d n(n+1)(2n+7)/6 + d(n+1) + 3n/2 per curve"), 3);
  EXPECT_EQ(power_of_n("big integers"), 0);
}

/// What flops say is what is claimed of their growth; operations on big integers cost more than one.
void expect_consistent_cost(const MethodInfo& info) {
  if (info.flops.find("integers") == std::string_view::npos)
    EXPECT_EQ(info.cost_exponent, std::max(1, power_of_n(info.flops))) << info.id;
  else
    EXPECT_GT(info.cost_exponent, 2) << info.id;
}

TEST(Roster, ClaimsTheGrowthOfItsFlops) {
  for (const auto* info : conversion_infos()) expect_consistent_cost(*info);
  for (const auto& kernel : kernels<double>(2)) expect_consistent_cost(*kernel.info);
}

TEST(Roster, APathPreparesAsItsConversionCosts) {
  const auto prepare_exponent = [](std::string_view id, Form form) {
    return find_kernel<double>(id, form, 2)->info->prepare_exponent;
  };
  EXPECT_EQ(prepare_exponent("horner", Form::power), 1);
  EXPECT_EQ(prepare_exponent("factorial:horner", Form::bernstein), 2);
  EXPECT_EQ(prepare_exponent("differences_centered:horner_centered", Form::bernstein), 3);
}

TEST_P(Method, StatesWhatItIs) {
  const auto& info = *kernel().info;
  EXPECT_THAT(std::string(info.id), testing::MatchesRegex("[a-z0-9_]+(:[a-z0-9_]+)?"));
  EXPECT_FALSE(info.label.empty());
  EXPECT_FALSE(info.citation.empty());
  EXPECT_FALSE(info.flops.empty());
  EXPECT_LE(info.min_degree, info.max_degree);
  EXPECT_GE(info.max_degree, 170);
  EXPECT_EQ(info.problem, Problem::evaluation);
}

TEST_P(BoundedMethod, KeepsItsBound) {
  const auto& stated = kernel().info->bound;
  int bounded = 0;  // with an infinite bound nothing is tested
  Inputs inputs(1);
  reference::ExactCurve exact;
  metric::TrialScale scale;
  for (const int dimension : {1, 2, 3})
    for (const int degree : {0, 1, 2, 3, 5, 8, 13, 20, 34, 60, 120}) {
      const auto& method = kernel(dimension);
      if (!supports(method, degree)) continue;
      for (int repeat = 0; repeat < 20; ++repeat) {
        auto coefficients = inputs.coefficients(degree, dimension);
        if (repeat % 4 == 3)  // magnitudes from 2^-40 to 2^40 side by side
          for (double& value : coefficients) value = std::ldexp(value, static_cast<int>(80 * inputs.symmetric() / 2));
        const auto curve = view(method.info->form, dimension, degree, coefficients);
        auto ts = parameters;
        for (int k = 0; k < 8; ++k) ts.push_back(inputs.unit());
        const auto points = evaluate(method, curve, ts);
        for (std::size_t k = 0; k < ts.size(); ++k) {
          scale.set(curve, ts[k]);
          const reference::Distance distance(exact.point(curve, ts[k]));
          const auto d = static_cast<std::size_t>(dimension);
          const double error = distance.to(std::span(points).subspan(k * d, d));
          const double bound = scale.bound(*stated, metric::double_arithmetic);
          bounded += std::isfinite(bound) ? 1 : 0;
          EXPECT_FALSE(metric::TrialScale::violates(error, bound))
              << method.info->id << " degree " << degree << " t " << ts[k] << " error " << error << " bound " << bound;
        }
      }
    }
  EXPECT_GT(bounded, 1000);
}

TEST_P(BoundedMethod, KeepsItsBoundInFloat) {
  const auto& stated = float_kernel().info->bound;
  int bounded = 0;  // with an infinite bound nothing is tested
  Inputs inputs(2);
  reference::ExactCurve exact;
  metric::TrialScale scale;
  for (const int degree : {0, 1, 2, 3, 8, 20, 34}) {
    const auto& method = float_kernel();
    if (!supports(method, degree)) continue;
    for (int repeat = 0; repeat < 20; ++repeat) {
      const auto drawn = inputs.coefficients(degree, 2);
      const std::vector<float> coefficients(drawn.begin(), drawn.end());
      const std::vector<double> widened(coefficients.begin(), coefficients.end());
      const auto t = static_cast<float>(inputs.unit());
      const auto point = evaluate<float>(method, view(method.info->form, 2, degree, coefficients), {t});
      const auto curve = view(method.info->form, 2, degree, widened);
      scale.set(curve, t);
      const double error =
          reference::Distance(exact.point(curve, t)).to(std::vector<double>(point.begin(), point.end()));
      const double bound = scale.bound(*stated, metric::float_arithmetic);
      bounded += std::isfinite(bound) ? 1 : 0;
      EXPECT_FALSE(metric::TrialScale::violates(error, bound))
          << method.info->id << " degree " << degree << " t " << t << " error " << error;
    }
  }
  EXPECT_GT(bounded, 50);
}

/// Where whole curves or their errors are subnormal, only the underflow term is left of a bound.
TEST_P(BoundedMethod, KeepsItsBoundWhereItUnderflows) {
  const auto& stated = kernel(1).info->bound;
  int bounded = 0;  // with an infinite bound nothing is tested
  Inputs inputs(10);
  reference::ExactCurve exact;
  metric::TrialScale scale;
  for (const int exponent : {-900, -960, -1020, -1060, -1070})
    for (const int degree : {0, 1, 2, 5, 20, 34}) {
      if (!supports(kernel(1), degree)) continue;
      for (int repeat = 0; repeat < 10; ++repeat) {
        auto coefficients = inputs.coefficients(degree, 1);
        for (double& value : coefficients) value = std::ldexp(value, exponent);
        const auto curve = view(kernel(1).info->form, 1, degree, coefficients);
        auto ts = parameters;
        for (int k = 0; k < 4; ++k) ts.push_back(inputs.unit());
        const auto points = evaluate(kernel(1), curve, ts);
        for (std::size_t k = 0; k < ts.size(); ++k) {
          scale.set(curve, ts[k]);
          const double error = reference::Distance(exact.point(curve, ts[k])).to(std::span(points).subspan(k, 1));
          const double bound = scale.bound(*stated, metric::double_arithmetic);
          bounded += std::isfinite(bound) ? 1 : 0;
          EXPECT_FALSE(metric::TrialScale::violates(error, bound))
              << kernel(1).info->id << " 2^" << exponent << " degree " << degree << " t " << ts[k] << " error "
              << error;
        }
      }
    }
  EXPECT_GT(bounded, 1000);
}

/// Even a method without a bound is right to first order where nothing is amplified much.
TEST_P(Method, IsRightOnMildCurves) {
  Inputs inputs(3);
  reference::ExactCurve exact;
  const auto& method = kernel();
  for (const int degree : {0, 1, 2, 3, 4, 6}) {
    for (int repeat = 0; repeat < 50; ++repeat) {
      const auto coefficients = inputs.coefficients(degree, 2);
      const auto curve = view(method.info->form, 2, degree, coefficients);
      const double t = inputs.unit();
      const auto point = evaluate(method, curve, {t});
      EXPECT_LE(reference::Distance(exact.point(curve, t)).to(point), 64 * 0x1p-53 * std::pow(3, degree))
          << method.info->id << " degree " << degree << " t " << t;
    }
  }
}

/// What rounding may change in a relation between two evaluations of curves in [-4, 4] of low degree.
double tolerance(int degree) { return 4 * 256 * 0x1p-53 * std::pow(3, degree); }

TEST_P(Method, ReproducesConstants) {
  const auto ts = parameters_for(*kernel().info);
  const auto& method = kernel();
  for (const int degree : {0, 1, 3, 6}) {
    std::vector<double> coefficients(static_cast<std::size_t>(2 * degree) + 2, 0);
    for (std::size_t k = 0; k < coefficients.size(); ++k)
      if (method.info->form != Form::power || k < 2) coefficients[k] = k % 2 == 0 ? 0.7 : -1.3;
    const auto points = evaluate(method, view(method.info->form, 2, degree, coefficients), ts);
    for (std::size_t k = 0; k < ts.size(); ++k) {
      const double outside = std::pow(std::abs(ts[k]) + std::abs(1 - ts[k]), degree);
      EXPECT_NEAR(points[2 * k], 0.7, tolerance(degree) * outside);
      EXPECT_NEAR(points[2 * k + 1], -1.3, tolerance(degree) * outside);
    }
  }
}

TEST_P(Method, IsAffinelyInvariant) {
  Inputs inputs(8);
  const auto& method = kernel();
  const bool points = method.info->form != Form::power;  // in power form only q_0 is moved by a translation
  for (const int degree : {0, 1, 2, 5}) {
    const auto c = inputs.coefficients(degree, 2);
    std::vector<double> image(c.size());
    for (std::size_t k = 0; k < c.size(); k += 2) {
      const double moved = points || k == 0 ? 1 : 0;
      image[k] = 2 * c[k] - c[k + 1] + moved;
      image[k + 1] = 0.5 * c[k] + c[k + 1] - moved;
    }
    const double t = inputs.unit();
    const auto p = evaluate(method, view(method.info->form, 2, degree, c), {t});
    const auto q = evaluate(method, view(method.info->form, 2, degree, image), {t});
    EXPECT_NEAR(q[0], 2 * p[0] - p[1] + 1, tolerance(degree));
    EXPECT_NEAR(q[1], 0.5 * p[0] + p[1] - 1, tolerance(degree));
  }
}

TEST_P(BernsteinMethod, ReversesWithItsControlPoints) {
  Inputs inputs(9);
  for (const int degree : {1, 2, 3, 6}) {
    const auto c = inputs.coefficients(degree, 1);
    const std::vector<double> reversed(c.rbegin(), c.rend());
    const double t = inputs.unit();
    const auto& one_axis = kernel(1);
    EXPECT_NEAR(evaluate(one_axis, view(Form::bernstein, 1, degree, c), {t})[0],
                evaluate(one_axis, view(Form::bernstein, 1, degree, reversed), {1 - t})[0], tolerance(degree));
  }
}

TEST_P(StableMethod, ScalesWithPowersOfTwo) {
  const auto ts = parameters_for(*kernel().info);
  const auto& method = kernel();
  Inputs inputs(4);
  for (const int degree : {0, 1, 3, 8, 20}) {
    const auto coefficients = inputs.coefficients(degree, 2);
    auto scaled = coefficients;
    for (double& value : scaled) value *= 0x1p+60;
    auto points = evaluate(method, view(method.info->form, 2, degree, coefficients), ts);
    for (double& value : points) value *= 0x1p+60;
    EXPECT_EQ(evaluate(method, view(method.info->form, 2, degree, scaled), ts), points) << "degree " << degree;
  }
}

TEST_P(Method, TreatsAxesAlike) {
  const auto ts = parameters_for(*kernel().info);
  Inputs inputs(5);
  for (const int degree : {1, 4, 20}) {
    const auto coefficients = inputs.coefficients(degree, 3);
    const auto points = evaluate(kernel(3), view(kernel(3).info->form, 3, degree, coefficients), ts);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double> one_axis;
      for (std::size_t i = axis; i < coefficients.size(); i += 3) one_axis.push_back(coefficients[i]);
      const auto values = evaluate(kernel(1), view(kernel(1).info->form, 1, degree, one_axis), ts);
      for (std::size_t k = 0; k < ts.size(); ++k) EXPECT_EQ(values[k], points[3 * k + axis]) << "degree " << degree;
    }
  }
}

TEST_P(Method, BatchEqualsOneByOne) {
  const auto ts = parameters_for(*kernel().info);
  Inputs inputs(6);
  const auto coefficients = inputs.coefficients(9, 2);
  const auto curve = view(kernel().info->form, 2, 9, coefficients);
  const auto points = evaluate(kernel(), curve, ts);
  for (std::size_t k = 0; k < ts.size(); ++k)
    EXPECT_EQ(evaluate(kernel(), curve, {ts[k]}),
              std::vector<double>(points.begin() + static_cast<std::ptrdiff_t>(2 * k),
                                  points.begin() + static_cast<std::ptrdiff_t>(2 * k + 2)));
}

/// Exactly.
TEST_P(EndPointMethod, InterpolatesEndPoints) {
  const auto& info = *kernel().info;
  Inputs inputs(7);
  for (const int degree : {1, 2, 7, 20, 90}) {
    const auto coefficients = inputs.coefficients(degree, 2);
    const auto points = evaluate(kernel(), view(info.form, 2, degree, coefficients), {0, 1});
    EXPECT_THAT(std::vector(points.begin(), points.begin() + 2),
                testing::ElementsAre(coefficients[0], coefficients[1]));
    EXPECT_THAT(std::vector(points.begin() + 2, points.end()),
                testing::ElementsAre(coefficients[coefficients.size() - 2], coefficients.back()));
  }
}

/// Where in the roster the methods are of which this holds.
auto methods_that(bool (*holds)(const MethodInfo& info)) {
  std::vector<std::size_t> places;
  for (std::size_t place = 0; place < kernels<double>(2).size(); ++place)
    if (holds(*kernels<double>(2)[place].info)) places.push_back(place);
  return testing::ValuesIn(places);
}

std::string name_of(const testing::TestParamInfo<std::size_t>& parameter) {
  const auto& info = *kernels<double>(2)[parameter.param].info;
  std::string id(info.id);
  std::ranges::replace(id, ':', '_');
  return id + "_" + std::string(name(info.form));
}

bool is_bounded(const MethodInfo& info) { return info.bound.has_value(); }
bool is_bernstein(const MethodInfo& info) { return info.form == Form::bernstein; }
bool is_stable(const MethodInfo& info) { return info.bit_stable; }
bool keeps_end_points(const MethodInfo& info) {
  return is_bernstein(info) && is_bounded(info) && info.id.find(':') == std::string_view::npos;
}

INSTANTIATE_TEST_SUITE_P(Roster, Method, testing::Range<std::size_t>(0, kernels<double>(2).size()), name_of);
INSTANTIATE_TEST_SUITE_P(Roster, BoundedMethod, methods_that(is_bounded), name_of);
INSTANTIATE_TEST_SUITE_P(Roster, BernsteinMethod, methods_that(is_bernstein), name_of);
INSTANTIATE_TEST_SUITE_P(Roster, StableMethod, methods_that(is_stable), name_of);
INSTANTIATE_TEST_SUITE_P(Roster, EndPointMethod, methods_that(keeps_end_points), name_of);

TEST(Roster, HasNoTwoMethodsOfOneName) {
  std::set<std::pair<std::string_view, Form>> seen;
  for (const auto& kernel : kernels<double>(2)) EXPECT_TRUE(seen.emplace(kernel.info->id, kernel.info->form).second);
}

TEST(Roster, SourceReportsPathsExist) {
  EXPECT_NE(find_kernel<double>("factorial:power_sum", Form::bernstein, 2), nullptr);
  EXPECT_NE(find_kernel<double>("forward_substitution:direct", Form::power, 2), nullptr);
  EXPECT_EQ(find_kernel<double>("forward_substitution:direct", Form::bernstein, 2), nullptr);
}

/// Textbook point: the cubic (1,1) (3,1) (4,2) (6,3) at t = 1/2 (Farin-style midpoint construction by hand:
/// (2,1) (3.5,1.5) (5,2.5); (2.75,1.25) (4.25,2); (3.5,1.625)), all intermediate values exact in binary.
TEST(Roster, HandComputedCubic) {
  const std::vector<double> coefficients{1, 1, 3, 1, 4, 2, 6, 3};
  for (const auto& kernel : kernels<double>(2)) {
    if (kernel.info->form != Form::bernstein) continue;
    EXPECT_THAT(evaluate(kernel, view(Form::bernstein, 2, 3, coefficients), {0.5}),
                testing::ElementsAre(testing::DoubleNear(3.5, 1e-14), testing::DoubleNear(1.625, 1e-14)))
        << kernel.info->id;
  }
}

/// The contraction canary: compiled with the flags of the kernels. (1 + 2^-30)^2 - (1 + 2^-29) is 0 when the product is
/// rounded and 2^-60 when it is fused.
TEST(FloatingPointContract, ForbidsContraction) {
  volatile double a = 1 + 0x1p-30;
  volatile double c = -(1 + 0x1p-29);
  const double x = a;
  const double y = c;
  EXPECT_EQ(x * x + y, 0);
  EXPECT_EQ(std::fma(x, x, y), 0x1p-60);
}

}  // namespace
}  // namespace bezierbench
