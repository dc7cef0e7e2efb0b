// SPDX-License-Identifier: MIT
// What every method in the roster must state and do, whatever it is; a wrong one cannot pass.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>

#include "core/evaluate/evaluation_test.hpp"
#include "experiments/requirements/requirements.hpp"

namespace bezierbench {
namespace {

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

class Method : public testing::TestWithParam<std::size_t> {};  ///< by its place in the roster

TEST_P(Method, StatesWhatItIs) {
  const auto& info = *kernels<double>(2)[GetParam()].info;
  EXPECT_THAT(std::string(info.id), testing::MatchesRegex("[a-z0-9_]+(:[a-z0-9_]+){0,3}"));
  EXPECT_FALSE(info.label.empty());
  EXPECT_FALSE(info.citation.empty());
  EXPECT_FALSE(info.flops.empty());
  EXPECT_LE(info.min_degree, info.max_degree);
  EXPECT_GE(info.max_degree, 170);
  EXPECT_EQ(info.problem, Problem::evaluation);
}

/// A property, and the place in the roster of a method that must have it.
struct Owed {
  const requirements::Property* property;
  std::size_t place;
};

void PrintTo(const Owed& owed, std::ostream* out) { *out << owed.property->id; }

std::vector<Owed> all_owed() {
  std::vector<Owed> all;
  const auto methods = requirements::evaluators();
  for (const auto& property : requirements::properties())
    for (std::size_t place = 0; place < methods.size(); ++place)
      if (property.concerns(methods[place].info())) all.push_back({&property, place});
  return all;
}

/// Runs once for each property of each method, and says so by its names.
class PropertyOfMethod : public testing::TestWithParam<Owed> {};

TEST_P(PropertyOfMethod, Holds) {
  const auto& [property, place] = GetParam();
  const auto outcome = property->decide(requirements::evaluators().at(place));
  EXPECT_GT(outcome.cases(), 0);
  EXPECT_EQ(outcome.broken(), 0) << property->statement << "; first broken: " << outcome.first();
}

std::string name_of(std::size_t place) {
  const auto& info = *kernels<double>(2)[place].info;
  std::string id(info.id);
  std::ranges::replace(id, ':', '_');
  return id + "_" + std::string(name(info.form));
}

INSTANTIATE_TEST_SUITE_P(Roster, Method, testing::Range<std::size_t>(0, kernels<double>(2).size()),
                         [](const auto& parameter) { return name_of(parameter.param); });
INSTANTIATE_TEST_SUITE_P(Roster, PropertyOfMethod, testing::ValuesIn(all_owed()), [](const auto& parameter) {
  return std::string(parameter.param.property->id) + "_" + name_of(parameter.param.place);
});

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
