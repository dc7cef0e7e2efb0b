// SPDX-License-Identifier: MIT
#include "core/batch/flops.hpp"

#include <gtest/gtest.h>

#include "core/evaluate/kernel.hpp"

namespace bezierbench::batch {
namespace {

double flops(std::string_view id, Form form, int degree, int dimension) {
  return flops_per_point(*find_kernel<double>(id, form, dimension)->evaluator, degree, dimension);
}

/// By the formulas that the methods state, worked out by hand for n = 10.
TEST(Flops, AreThoseThatTheMethodsState) {
  EXPECT_EQ(flops("horner", Form::power, 10, 2), 40);                      // 2dn
  EXPECT_EQ(flops("horner_fma", Form::power, 10, 3), 60);                  // dn fma
  EXPECT_EQ(flops("horner_bernstein", Form::bernstein, 10, 2), 71);        // n(1+3d) + 1
  EXPECT_EQ(flops("horner_bernstein_fma", Form::bernstein, 10, 2), 71);    // n(1+d) + dn fma + 1
  EXPECT_EQ(flops("de_casteljau", Form::bernstein, 10, 1), 166);           // 3d n(n+1)/2 + 1
  EXPECT_EQ(flops("de_casteljau_fma", Form::bernstein, 10, 2), 440);       // 2 fma, d n(n+1)/2 times
  EXPECT_EQ(flops("de_casteljau_lerp_fma", Form::bernstein, 10, 3), 495);  // 1 sub + 1 fma, d n(n+1)/2 times
  EXPECT_EQ(flops("compensated_horner", Form::power, 10, 2), 242);         // 11dn + d, of them dn fma
  EXPECT_EQ(flops("exact_dd:horner_dd", Form::bernstein, 10, 1), 131);     // 12dn + d, of them dn fma
}

TEST(Flops, OfADegreeOfZeroAreThoseOfTheParameter) {
  EXPECT_EQ(flops("horner", Form::power, 0, 3), 0);
  EXPECT_EQ(flops("de_casteljau", Form::bernstein, 0, 2), 1);  // 1 - t
}

TEST(Flops, AreKnownOfTheBatchRosterOnly) {
  EXPECT_THROW(flops("direct", Form::bernstein, 10, 2), std::invalid_argument);
}

}  // namespace
}  // namespace bezierbench::batch
