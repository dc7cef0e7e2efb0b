// SPDX-License-Identifier: MIT
#include "experiments/bundle/json_object.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/bundle/machine.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

TEST(Facts, AreNamedByTheirPlaceInTheOrderOfTheFile) {
  EXPECT_EQ(facts(R"({"z": "text", "cpu": {"smt": false, "cores": 2}, "load": [0.5, "unknown"]})", "m.json"),
            (std::vector<Fact>{
                {"z", "text"}, {"cpu.smt", "false"}, {"cpu.cores", "2"}, {"load.0", "0.5"}, {"load.1", "unknown"}}));
}

TEST(Facts, OfAnEmptyObjectAreNone) { EXPECT_TRUE(facts("{}", "m.json").empty()); }

TEST(Facts, OfThisMachineHoldTheBuild) {
  const auto all = facts(
      machine_json({.compiler = "GNU", .flags = "-O3", .build_type = "", .fp_flags = "", .program_version = ""}, ""),
      "machine.json");
  EXPECT_NE(std::ranges::find(all, Fact{"build.compiler", "GNU"}), all.end());
  EXPECT_NE(std::ranges::find(all, Fact{"build.build_type", "unknown"}), all.end());
}

TEST(Facts, NoObjectIsRefusedWithItsPlace) {
  const auto message = [](std::string_view text) -> std::string {
    try {
      (void)facts(text, "m.json");
      return "";
    } catch (const Failure& failure) {
      return failure.what();
    }
  };
  EXPECT_TRUE(message("{\n \"a\": }").starts_with("m.json:2:7: malformed JSON; ")) << message("{\n \"a\": }");
  EXPECT_TRUE(message("[1]").starts_with("m.json: not a JSON object; "));
}

}  // namespace
}  // namespace bezierbench::bundle
