// SPDX-License-Identifier: MIT
#include "experiments/number/fault.hpp"

#include <gtest/gtest.h>

namespace bezierbench::number {
namespace {

TEST(NumberFault, SaysWhetherANumberIsTooSmallOrTooLarge) {
  for (const auto* text : {"1e-400", "-1E-400", "+.5e-400", "0x1p-2000", "0x.8p-99999999999999999999"})
    EXPECT_TRUE(fault(text).starts_with("is too small for a double;")) << text;
  for (const auto* text : {"1e400", "-1e+400", "0.1e999", "0x1p+2000", "1e99999999999999999999"})
    EXPECT_TRUE(fault(text).starts_with("is too large for a double;")) << text;
  EXPECT_TRUE(fault("0." + std::string(400, '0') + "1").starts_with("is too small"));
  EXPECT_TRUE(fault(std::string(400, '9')).starts_with("is too large"));
}

TEST(NumberFault, SaysWhatElseIsWrong) {
  for (const auto* text : {"(1", "2)", "[1]"}) EXPECT_NE(fault(text).find("without brackets"), std::string_view::npos);
  for (const auto* text : {"", "x", "nan", "-inf", "1e400x", "0x", "1 2"})
    EXPECT_TRUE(fault(text).starts_with("is not a finite number;")) << text;
}

}  // namespace
}  // namespace bezierbench::number
