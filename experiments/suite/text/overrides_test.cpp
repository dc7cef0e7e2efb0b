// SPDX-License-Identifier: MIT
#include "experiments/suite/text/overrides.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/suite/vocabulary_test.hpp"

namespace bezierbench::suite {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Study study(const std::string& id, std::string_view kind) {
  Study made;
  made.id = id;
  made.kind = &studies::kind(kind);
  made.degree = {4, 8};
  return made;
}

std::vector<Suite> two_suites() {
  return {{"one", "", 1, {study("a-1", "accuracy"), study("t-1", "timing")}},
          {"two", "", 1, {study("a-2", "accuracy")}}};
}

std::vector<Suite> applied(const Overrides& overrides) {
  auto suites = two_suites();
  apply(overrides, suites, test_vocabulary());
  return suites;
}

std::string refused(const Overrides& overrides) {
  const std::string line = failure_of([&] { applied(overrides); });
  EXPECT_THAT(line, StartsWith("--"));
  return line;
}

Overrides setting(std::vector<std::string> set) {
  Overrides overrides;
  overrides.set = std::move(set);
  return overrides;
}

TEST(Overrides, NothingSetChangesNothing) {
  EXPECT_EQ(applied({}).size(), 2U);
  EXPECT_THAT(applied({})[0].studies[0].degree, ElementsAre(4, 8));
}

TEST(Overrides, SetsAxesInEveryStudy) {
  const auto suites = applied(setting({"degree=3,0x1p2", "coordinate_range=0x1p-1022,1e3", "t_interval=0:0.2,-1:1",
                                       "scalar=float,double", "generator=dyadic"}));
  for (const Suite& suite : suites)
    for (const Study& changed : suite.studies) {
      EXPECT_THAT(changed.degree, ElementsAre(3, 4));
      EXPECT_THAT(changed.coordinate_range, ElementsAre(0x1p-1022, 1e3));
      EXPECT_THAT(changed.t_interval, ElementsAre(Interval{0, 0.2}, Interval{-1, 1}));
      EXPECT_THAT(changed.scalar, ElementsAre(ScalarKind::float32, ScalarKind::float64));
      EXPECT_THAT(changed.generator, ElementsAre("dyadic"));
    }
}

TEST(Overrides, SetsKeysOfAKindInStudiesOfThisKindAlone) {
  Overrides overrides = setting({"modes=batch,latency"});
  overrides.only = "t-*";
  EXPECT_THAT(applied(overrides)[0].studies[0].modes, ElementsAre(Mode::batch, Mode::latency));
  EXPECT_EQ(
      refused(setting({"modes=batch"})),
      "--set modes=batch: study \"a-1\": kind \"accuracy\" does not have the key modes; kind timing has it; choose "
      "studies with --only");
  EXPECT_THAT(refused(setting({"budget=5"})), HasSubstr("kinds search, guarantees have it"));
}

/// A fault that involves two keys is reported at the option that changed either of them, even if the study is in a
/// file.
TEST(Overrides, ErrorsNameTheOptionAlsoWhereTheKeyIsInTheFile) {
  auto suites = two_suites();
  Study& first = suites[0].studies[0];
  first.places = {"x.toml", {4, 1}, {{"degree", {{5, 1}, {5, 10}, {{5, 11}, {5, 14}}}}}, {}};
  first.degree = {4, 30};
  first.form = Form::power;
  Overrides overrides = setting({"generator=multiple_root"});
  overrides.only = "a-1";
  EXPECT_THAT(failure_of([&] { apply(overrides, suites, test_vocabulary()); }),
              StartsWith("--set generator=multiple_root: study \"a-1\": generator \"multiple_root\" draws"));
}

TEST(Overrides, SetsSeedTrialsAndReplicates) {
  Overrides overrides = setting({"replicates=3"});
  overrides.seed = 7;
  overrides.trials = 12;
  for (const Suite& suite : applied(overrides)) {
    EXPECT_EQ(suite.seed, 7U);
    EXPECT_EQ(suite.studies[0].trials, 12);
    EXPECT_EQ(suite.studies[0].replicates, 3);
  }
}

TEST(Overrides, OnlyAndNoTimingChoose) {
  Overrides overrides;
  overrides.only = "*-1";
  auto suites = applied(overrides);
  ASSERT_EQ(suites.size(), 1U);  // a suite without studies is gone
  EXPECT_EQ(suites[0].studies.size(), 2U);
  overrides.no_timing = true;
  suites = applied(overrides);
  ASSERT_EQ(suites[0].studies.size(), 1U);
  EXPECT_EQ(suites[0].studies[0].id, "a-1");
}

TEST(Overrides, ErrorsNameTheOption) {
  EXPECT_THAT(refused(setting({"degree=x"})), StartsWith("--set degree=x: degree must be a whole number"));
  EXPECT_THAT(refused(setting({"degree=1024"})), StartsWith("--set degree=1024: study \"a-1\": degree must be 0 to"));
  EXPECT_THAT(refused(setting({"degre=3"})), HasSubstr("did you mean \"degree\"?"));
  EXPECT_THAT(refused(setting({"id=3"})), HasSubstr("unknown axis \"id\""));
  EXPECT_THAT(refused(setting({"degree"})), HasSubstr("axis=v1,v2"));
  EXPECT_THAT(refused(setting({"degree="})), HasSubstr("no value"));
  EXPECT_THAT(refused(setting({"degree=3,,4"})), HasSubstr("a whole number"));
  EXPECT_THAT(refused(setting({"degree=3", "degree=4"})), HasSubstr("sets this too"));
  EXPECT_THAT(refused(setting({"t_interval=0.2"})), HasSubstr("[a, b]"));
  EXPECT_THAT(refused(setting({"t_interval=1:0"})), HasSubstr("a <= b"));
  EXPECT_THAT(refused(setting({"methods=hornr"})), HasSubstr("did you mean \"horner\"?"));
  EXPECT_THAT(refused(setting({"replicates=1,2"})), HasSubstr("one value"));
  EXPECT_THAT(refused(setting({"degree=5", "coordinate_range=0.5", "generator=integer"})),
              StartsWith("--set coordinate_range=0.5: study \"a-1\": generator \"integer\""));
  EXPECT_THAT(refused(setting({"generator=weights_mild"})),
              StartsWith("--set generator=weights_mild: study \"a-1\": generator \"weights_mild\" draws weights"));
  EXPECT_THAT(refused(setting({"generator=multiple_root", "degree=34"})),
              StartsWith("--set degree=34: study \"a-1\": generator \"multiple_root\""));
  Overrides overrides;
  overrides.trials = 0;
  EXPECT_THAT(refused(overrides), StartsWith("--trials 0: study \"a-1\": trials must be at least 1"));
  overrides = {};
  overrides.seed = std::uint64_t{1} << 63U;
  EXPECT_THAT(refused(overrides), StartsWith("--seed 9223372036854775808: seed must be 0 to 2^63-1"));
  overrides = {};
  overrides.only = "a_1";
  EXPECT_THAT(refused(overrides), StartsWith("--only a_1: no study matches; did you mean \"a-1\"?"));
  overrides.only_option = "--study";
  EXPECT_THAT(refused(overrides), StartsWith("--study a_1: no study matches; did you mean \"a-1\"?"));
  overrides.only = "";  // as in `--only "$STUDY"` with an unset variable
  EXPECT_EQ(refused(overrides), "--study: is empty; name a study, or leave the option out");
  overrides = {};
  overrides.only = "t*";
  overrides.no_timing = true;
  EXPECT_THAT(refused(overrides), HasSubstr("only timing studies"));
}

}  // namespace
}  // namespace bezierbench::suite
