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
  EXPECT_EQ(flops("direct", Form::bernstein, 10, 2), 87);                  // 2n powers, 2(1+d)(n+1) in terms, 1-t
  EXPECT_EQ(flops("wozny_chudy", Form::bernstein, 10, 2), 123);            // n(6+3d) + 3
  EXPECT_EQ(flops("barycentric_uniform", Form::bernstein, 10, 3), 102);    // (n+1)(3+2d) + d
  EXPECT_EQ(flops("horner_bernstein", Form::rational, 10, 2), 103);        // n(1+3(d+1)) + 1 + d
  EXPECT_EQ(flops("de_casteljau_farin", Form::rational, 10, 2), 606);      // (5+3d) n(n+1)/2 + 1
  EXPECT_EQ(flops("exact_dd:horner_dd", Form::bernstein, 10, 1), 131);     // 12dn + d, of them dn fma
}

TEST(Flops, OfADegreeOfZeroAreThoseOfTheParameter) {
  EXPECT_EQ(flops("horner", Form::power, 0, 3), 0);
  EXPECT_EQ(flops("de_casteljau", Form::bernstein, 0, 2), 1);  // 1 - t
}

TEST(Flops, AreKnownOfTheBatchRosterOnly) {
  EXPECT_THROW(flops("direct_pow", Form::bernstein, 10, 2), std::invalid_argument);
}

}  // namespace
}  // namespace bezierbench::batch
