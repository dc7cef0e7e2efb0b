// SPDX-License-Identifier: MIT
#include "experiments/bundle/manifest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/bundle/machine.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Manifest example() {
  return {.suites = {"report", "extra"},
          .suite_digest = "d1",
          .seed = std::numeric_limits<std::uint64_t>::max(),
          .state = "partial",
          .accuracy_digest = "d2",
          .program_version = "0.1.0",
          .git_commit = "abc",
          .git_clean = true,
          .fp_flags = "-ffp-contract=off"};
}

std::string refusal(std::string_view text, Exit exit = Exit::input_output) {
  try {
    (void)parse_manifest(text, "B/bundle.json");
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), exit);
    EXPECT_EQ(std::string(failure.what()).find('\n'), std::string::npos);
    return failure.what();
  }
  return "accepted";
}

TEST(Manifest, TextIsFixedToTheByte) {
  EXPECT_EQ(manifest_json(example()), R"({
  "schema_version": 3,
  "suites": {
    "ids": [
      "report",
      "extra"
    ],
    "digest": "d1"
  },
  "seed": 18446744073709551615,
  "state": "partial",
  "accuracy_digest": "d2",
  "program_version": "0.1.0",
  "git_commit": "abc",
  "git_clean": true,
  "fp_flags": "-ffp-contract=off"
}
)");
}

TEST(Manifest, ReadsBackLargeSeedsIncluded) {
  Manifest manifest = example();
  for (const std::uint64_t seed : {std::uint64_t{0}, (std::uint64_t{1} << 53) + 1, ~std::uint64_t{0}}) {
    manifest.seed = seed;
    EXPECT_EQ(parse_manifest(manifest_json(manifest), "f"), manifest);
  }
  manifest.git_clean = false;
  manifest.suites.clear();
  EXPECT_EQ(parse_manifest(manifest_json(manifest), "f"), manifest);
}

TEST(Manifest, PassesOverKeysOfLaterVersions) {
  auto json = nlohmann::ordered_json::parse(manifest_json(example()));
  json["more"] = 1;
  EXPECT_EQ(parse_manifest(json.dump(), "f"), example());
}

TEST(Manifest, EveryKeyIsNeededAndTyped) {
  const auto whole = nlohmann::ordered_json::parse(manifest_json(example()));
  for (const auto& item : whole.items()) {
    auto json = whole;
    json.erase(item.key());
    const auto key = item.key() == "suites" ? "ids" : item.key();
    EXPECT_THAT(refusal(json.dump()),
                StartsWith("B/bundle.json: '" + item.key() + "' is missing or of another type; "));
    json[item.key()] = nlohmann::ordered_json::object();
    EXPECT_THAT(refusal(json.dump()), StartsWith("B/bundle.json: '" + key + "' is missing or of another type; "));
  }
}

TEST(Manifest, RefusesWrongValues) {
  const auto with = [](const char* key, nlohmann::ordered_json value, Exit exit = Exit::input_output) {
    auto json = nlohmann::ordered_json::parse(manifest_json(example()));
    json[key] = std::move(value);
    return refusal(json.dump(), exit);
  };
  EXPECT_THAT(with("state", "finished"), HasSubstr("complete or partial"));
  EXPECT_THAT(with("schema_version", 4), HasSubstr("schema_version is 4, this program reads 3; use a newer program"));
  EXPECT_THAT(
      with("schema_version", 2, Exit::usage),
      HasSubstr("schema_version is 2, this program reads 3; run the suite again, or use the program of commit "));
}

TEST(Manifest, MalformedJsonIsLocated) {
  EXPECT_THAT(refusal("{\n  \"a\": }\n"), StartsWith("B/bundle.json:2:8: malformed JSON; "));
  EXPECT_THAT(refusal(""), StartsWith("B/bundle.json:1:1: malformed JSON; "));
  EXPECT_THAT(refusal("{\"seed\": 1e999}"), StartsWith("B/bundle.json: a number beyond every double; "));
  EXPECT_THAT(refusal("[]"), StartsWith("B/bundle.json: not a JSON object; "));
  const std::string text = manifest_json(example());
  for (std::size_t length = 0; length + 2 < text.size(); ++length)
    ASSERT_THAT(refusal(std::string_view(text).substr(0, length)), HasSubstr("malformed JSON"));
}

TEST(Facts, AreNamedByTheirPlaceInTheOrderOfTheFile) {
  EXPECT_EQ(bundle::facts(R"({"z": "text", "cpu": {"smt": false, "cores": 2}, "load": [0.5, "unknown"]})", "m.json"),
            (std::vector<Fact>{
                {"z", "text"}, {"cpu.smt", "false"}, {"cpu.cores", "2"}, {"load.0", "0.5"}, {"load.1", "unknown"}}));
}

TEST(Facts, OfAnEmptyObjectAreNone) { EXPECT_TRUE(bundle::facts("{}", "m.json").empty()); }

}  // namespace
}  // namespace bezierbench::bundle
