// SPDX-License-Identifier: MIT
#include "core/operations/operations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/evaluate/kernel/kernel.hpp"
#include "core/operations/counting.hpp"

namespace bezierbench {
namespace {

const Kernel<double>& kernel(std::string_view id, Form form) { return *find_kernel<double>(id, form, 2); }

double flops(std::string_view id, Form form, int degree, int dimension) {
  return point_operations(*kernel(id, form).evaluator, degree, dimension, Layout::points)->flops();
}

/// The operations of a point in the order of the kinds.
testing::AssertionResult are(const std::optional<ByOperation>& found, std::array<double, operation_kinds> wanted) {
  if (!found) return testing::AssertionFailure() << "not counted";
  if (found->values == wanted) return testing::AssertionSuccess();
  auto failure = testing::AssertionFailure();
  for (const double value : found->values) failure << value << ' ';
  return failure;
}

std::optional<ByOperation> in_one_vector(std::string_view id, Form form, int degree) {
  return point_operations(*kernel(id, form).evaluator, degree, 3, Layout::axes);
}

std::optional<ByOperation> prepared(std::string_view id, Form form, int degree, int dimension) {
  const auto& of = kernel(id, form);
  return curve_operations(*of.evaluator, of.conversion, degree, dimension, Layout::points);
}

TEST(Operations, OfADegreeOfZeroAreThoseOfTheParameter) {
  EXPECT_EQ(flops("horner", Form::power, 0, 3), 0);
  EXPECT_EQ(flops("de_casteljau", Form::bernstein, 0, 2), 1);  // 1 - t
}

TEST(Operations, AreCountedByKind) {
  EXPECT_TRUE(are(in_one_vector("de_casteljau", Form::bernstein, 3), {1 + 6, 12, 0, 0, 0}));
  EXPECT_TRUE(are(in_one_vector("de_casteljau_fma", Form::bernstein, 3), {0, 0, 12, 0, 0}));
  EXPECT_TRUE(are(in_one_vector("de_casteljau_lerp_fma", Form::bernstein, 3), {6, 0, 6, 0, 0}));
  EXPECT_TRUE(are(in_one_vector("horner_bernstein", Form::bernstein, 5), {1 + 5, 15, 0, 0, 0}));
  EXPECT_TRUE(are(in_one_vector("wozny_chudy", Form::bernstein, 4), {2 + 12, 20, 0, 5, 0}));
}

// The weight goes with the coordinates: one division by it, and its triangle costs nothing more.
TEST(Operations, OfHomogeneousCoordinatesShareTheirVector) {
  EXPECT_TRUE(are(in_one_vector("de_casteljau", Form::rational, 3), {1 + 6, 12, 0, 1, 0}));
  EXPECT_EQ(side_by_side(*kernel("de_casteljau", Form::rational).evaluator, 2), 3);
  EXPECT_EQ(side_by_side(*kernel("wozny_chudy", Form::rational).evaluator, 2), 2);
  EXPECT_EQ(side_by_side(*kernel("de_casteljau", Form::bernstein).evaluator, 2), 2);
}

// Products with binomials count, the binomials themselves do not.
TEST(Operations, OfPreparationAreThoseOnCoefficients) {
  EXPECT_TRUE(are(prepared("de_casteljau", Form::bernstein, 5, 2), {}));
  EXPECT_TRUE(are(prepared("direct", Form::bernstein, 5, 2), {}));
  EXPECT_TRUE(are(prepared("horner_bernstein", Form::bernstein, 5, 2), {0, 12, 0, 0, 0}));
  EXPECT_TRUE(are(prepared("differences:horner", Form::bernstein, 5, 2), {30, 12, 0, 0, 0}));
  EXPECT_TRUE(are(prepared("triangle:horner_bernstein", Form::power, 5, 1), {15, 6, 0, 6, 0}));
  EXPECT_TRUE(are(prepared("de_casteljau", Form::rational, 5, 2), {0, 12, 0, 0, 0}));
}

TEST(Operations, AreUnknownWhereNoScalarCanCount) {
  EXPECT_EQ(point_operations(*kernel("direct_pow", Form::bernstein).evaluator, 5, 2, Layout::axes), std::nullopt);
  EXPECT_EQ(prepared("exact:horner", Form::bernstein, 5, 2), std::nullopt);
  EXPECT_EQ(prepared("correctly_rounded", Form::bernstein, 5, 2), std::nullopt);
  EXPECT_NE(in_one_vector("exact:horner", Form::bernstein, 5), std::nullopt);
  EXPECT_NE(in_one_vector("correctly_rounded", Form::bernstein, 5), std::nullopt);
  const MethodInfo stranger{};
  EXPECT_EQ(point_operations(stranger, 5, 2, Layout::axes), std::nullopt);
}

TEST(Operations, AreKnownOfEveryMethodAtTheLimitsOfItsDegrees) {
  for (const auto& one : kernels<double>(3))
    for (const int degree : {one.info->min_degree, std::min(one.info->max_degree, 40)})
      if (one.info->bit_stable) {
        EXPECT_NE(point_operations(*one.evaluator, degree, 3, Layout::points), std::nullopt) << one.info->id;
      }
}

// No evaluator takes a square root; a counting scalar nevertheless has one.
TEST(Counting, KnowsEveryKind) {
  using counting::Counting;
  counting::tape = {{}, {{1, 10, 100, 1000, 10000}}};
  const auto a = Counting::input(4, 0);
  const auto b = Counting::input(2);
  const auto two = Counting(1) + Counting(1);
  EXPECT_TRUE(are(counting::tape.count, {})) << "of the degree only";
  const auto result = abs(-(sqrt(a).fused(two, b) / b - a * two + b));
  EXPECT_TRUE(are(counting::tape.count, {2, 1, 1, 1, 1}));
  EXPECT_EQ(result.ready(), 10000 + 100 + 1000 + 1 + 1);
  EXPECT_EQ(static_cast<double>(result), 3);
  EXPECT_EQ((b * b).ready(), counting::always) << "t has no part in it";
  EXPECT_TRUE(result > b && b < result && result >= b && b <= result && !(b == result));
}

/// Latencies that tell every kind apart.
constexpr ByOperation latency{{1, 100, 10000, 1000000, 1e8}};

// Only what t has a part in waits: the differences of control points do not.
TEST(Chains, BeginAtTheParameter) {
  const auto chain = [](std::string_view id, Form form, int degree) {
    return *point_chain(*kernel(id, form).evaluator, degree, latency);
  };
  EXPECT_EQ(chain("horner", Form::power, 7), 7 * 101);
  EXPECT_EQ(chain("horner_fma", Form::power, 7), 7 * 10000);
  EXPECT_EQ(chain("horner_fma", Form::power, 0), 0);
  EXPECT_EQ(chain("de_casteljau", Form::bernstein, 7), 1 + 7 * 101);
  EXPECT_EQ(chain("de_casteljau_fma", Form::bernstein, 7), 7 * 20000);
  EXPECT_EQ(chain("de_casteljau_lerp_fma", Form::bernstein, 7), 7 * 10000 + 6) << "of the first level only fused";
  EXPECT_EQ(chain("estrin", Form::power, 7), 3 * 101) << "its powers are ready before";
  EXPECT_EQ(chain("de_casteljau", Form::rational, 2), 1 + 2 * 101 + 1000000);
}

}  // namespace
}  // namespace bezierbench
