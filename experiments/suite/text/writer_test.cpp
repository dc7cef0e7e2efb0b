// SPDX-License-Identifier: MIT
#include "experiments/suite/text/writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>

#include "experiments/suite/kind.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/vocabulary_test.hpp"

namespace bezierbench::suite {
namespace {

/// Whether the studies are of one kind and all its keys have equal text.
bool equal(const Study& a, const Study& b) {
  if (a.kind != b.kind) return false;
  return std::ranges::all_of(fields_of(kind_of(a)), [&](const Field* field) {
    return !applies(*field, a) || to_text(*field, a) == to_text(*field, b);
  });
}

void expect_equal(const std::vector<Suite>& a, const std::vector<Suite>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].title, b[i].title);
    EXPECT_EQ(a[i].seed, b[i].seed);
    ASSERT_EQ(a[i].studies.size(), b[i].studies.size());
    for (std::size_t j = 0; j < a[i].studies.size(); ++j) {
      EXPECT_TRUE(equal(a[i].studies[j], b[i].studies[j])) << a[i].studies[j].id;
    }
  }
}

std::vector<Suite> read_back(const std::vector<Suite>& suites) {
  return parse_suites(to_toml(suites), "resolved", test_vocabulary());
}

/// Random suites in which every field takes many values.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  std::size_t below(std::size_t n) { return bits_() % n; }

  double real() {
    while (true) {
      // Whole numbers from 2^53 to 2^70 are among them: TOML's integers end at 2^63.
      const double x = below(3) == 0 ? std::floor(std::ldexp(static_cast<double>(bits_()), static_cast<int>(below(7))))
                                     : std::abs(std::bit_cast<double>(bits_()));
      if (x <= 0x1p1020) return x;  // where ranges end; false for NaN
    }
  }

  template <class T>
  std::vector<T> some(const std::vector<T>& all) {
    std::set<T> chosen;
    while (chosen.empty() || below(2) == 0) chosen.insert(all[below(all.size())]);
    return {chosen.begin(), chosen.end()};
  }

  Study study(const std::string& id) {
    const auto& known = test_vocabulary();
    Study made;
    made.id = id;
    made.title = below(2) == 0 ? "plain" : "quote \" backslash \\ tab \t new\nline \x7f \u00e9 [x] # no = comment";
    const Kind& kind = *studies::kinds()[below(studies::kinds().size())];
    made.kind = &kind;
    made.form = kind.inputs.forms[below(kind.inputs.forms.size())];
    made.degree = some<int>({1, 2, 20, 1023});
    if (kind.inputs.degree == DegreeUse::not_a_key) made.degree.clear();
    made.coordinate_range = some<double>({real(), real(), real(), 0, 5e-324, 0x1p+1020});
    const double edge = real();
    made.t_interval = {Interval{-edge, edge}, Interval{0, real()}};
    if (kind.inputs.parameters == Parameters::from_0_to_1) made.t_interval = {{0.25, 0.75}, {0, 1}};
    if (kind.inputs.parameters == Parameters::whole) made.t_interval = {{0, 1}};
    made.generator = made.form == Form::rational ? some<std::string>({"weights_mild", "weights_wild"})
                                                 : some<std::string>({"continuous", "dyadic"});
    made.dimension = some<int>({1, 2, 3});
    made.methods = below(2) == 0 ? std::vector<std::string>{} : std::vector<std::string>{"*"};
    made.trials = 1 + static_cast<std::int64_t>(bits_() >> 34U);
    made.replicates = 1 + static_cast<std::int64_t>(bits_() >> 45U);
    if (kind.has_baseline) made.baseline = some<std::string>({"exact", known.methods[0], known.methods[1]});
    made.budget = 1 + static_cast<std::int64_t>(bits_() >> 1U);
    made.decomposed_trials = static_cast<std::int64_t>(below(2) * (bits_() >> 1U));
    made.points = some<int>({2, 3, 1025});
    if (kind.inputs.sets == SetUse::required || (kind.inputs.sets == SetUse::optional && below(2) == 0)) {
      made.curves = some<std::string>({"named#css_*", "logo.svg", "icons"});
      if (below(2) == 0) made.curves_sha256 = {made.curves.size(), std::string(64, 'a')};
      made.parameters = 2 + static_cast<std::int64_t>(below(100));
      made.parameters_from = below(2) == 0 ? ParameterSource::grid : ParameterSource::drawn;
      made.placement = some<Placement>({Placement::stored, Placement::scaled, Placement::translated});
      if (below(2) == 0) made.dimension.clear();
      if (below(2) == 0) made.places.keys["curve"];
    }
    made.order = some<int>({0, 1, 2, 20});
    made.tolerance = some<double>({1e-3, 1e-12, 5e-324});
    made.modes = some<Mode>({Mode::one_shot, Mode::latency, Mode::batch});
    made.published = below(2) == 0 ? "" : known.published_files[0];
    return made;
  }

  std::vector<Suite> suites() {
    std::vector<Suite> made(1 + below(3));
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i].id = "suite" + std::to_string(i);
      made[i].title = "Title";
      made[i].seed = bits_() >> 1U;
      for (std::size_t j = 0; j <= below(3); ++j) {
        made[i].studies.push_back(study(std::to_string(i) + "." + std::to_string(j)));
      }
    }
    return made;
  }

 private:
  std::mt19937_64 bits_;
};

TEST(Writer, ReadsBackToEqualValues) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto suites = Random(seed).suites();
    SCOPED_TRACE(to_toml(suites));
    std::vector<Suite> back;
    ASSERT_EQ(failure_of([&] { back = read_back(suites); }), "");
    expect_equal(suites, back);
    EXPECT_EQ(to_toml(back), to_toml(suites));
    if (HasFailure()) return;
  }
}

TEST(Writer, ReportSuiteReadsBack) {
  const std::vector<Suite> suites{
      read_suite(BEZIERBENCH_SOURCE_DIR "/experiments/suites/report.toml", test_vocabulary())};
  expect_equal(suites, read_back(suites));
}

TEST(Writer, OneSuiteIsWrittenAsPeopleWriteIt) {
  Study study;
  study.id = "a";
  study.kind = &studies::accuracy_kind.asks;
  study.degree = {4};
  study.coordinate_range = {1e6};
  const std::vector<Suite> suites{{"s", "T", 1, {study}}};
  EXPECT_EQ(to_toml(suites),
            "schema_version = 1\n\n[suite]\nid = \"s\"\ntitle = \"T\"\nseed = 1\n\n[[study]]\nid = \"a\"\n"
            "kind = \"accuracy\"\ncurve = \"bernstein\"\ndimension = [2]\ndegree = [4]\n"
            "coordinate_range = [1e+06]\nt_interval = [[0, 1]]\ngenerator = [\"continuous\"]\nscalar = [\"double\"]\n"
            "trials = 1000\nreplicates = 1\nbaseline = [\"exact\"]\n");
}

TEST(Writer, SeveralSuitesAreNoSingleOne) {
  const auto several = Random(3).study("a");
  const std::vector<Suite> suites{{"s", "", 1, {several}}, {"r", "", 1, {Random(4).study("b")}}};
  EXPECT_THAT(failure_of([&] { parse_suite(to_toml(suites), "x.toml", test_vocabulary()); }),
              ::testing::StartsWith("x.toml: one suite is expected"));
}

}  // namespace
}  // namespace bezierbench::suite
