// SPDX-License-Identifier: MIT
#include "experiments/suite/text/reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <set>
#include <string>

#include "experiments/suite/kind.hpp"
#include "experiments/suite/validate.hpp"
#include "experiments/suite/vocabulary_test.hpp"

namespace bezierbench::suite {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string head = "schema_version = 1\n[suite]\nid = \"s\"\n[[study]]\nid = \"a\"\n";  // five lines
const std::string minimal = head + "kind = \"accuracy\"\n";                                   // six

Suite parsed(const std::string& text) { return parse_suites(text, "x.toml", test_vocabulary()).front(); }

std::string refused(const std::string& text) {
  const std::string line = failure_of([&] { parsed(text); });
  EXPECT_THAT(line, StartsWith("x.toml:"));
  return line;
}

TEST(Reader, ReadsTheReportSuite) {
  const Suite suite = read_suites(BEZIERBENCH_SOURCE_DIR "/experiments/suites/report.toml", test_vocabulary()).front();
  EXPECT_EQ(suite.id, "report");
  EXPECT_EQ(suite.seed, 1U);
  ASSERT_EQ(suite.studies.size(), 11U);
  const Study& ranges = suite.studies[3];
  EXPECT_EQ(ranges.id, "2.3.2-bezier");
  EXPECT_TRUE(studies::is_kind(ranges, studies::accuracy_kind));
  EXPECT_THAT(ranges.degree, ElementsAre(20));
  EXPECT_THAT(ranges.coordinate_range, ElementsAre(1e-6, 1e-4, 1e-2, 1, 10, 1e2, 1e4, 1e6));
  EXPECT_THAT(ranges.generator, ElementsAre("report", "continuous"));
  EXPECT_THAT(ranges.baseline, ElementsAre("direct", "exact"));
  EXPECT_EQ(ranges.trials, 1000);
  EXPECT_EQ(ranges.replicates, 400);
  EXPECT_EQ(ranges.published, "report_tables.csv");
  EXPECT_THAT(suite.studies[5].t_interval,
              ElementsAre(Interval{0, 0.2}, Interval{0.4, 0.6}, Interval{0.2, 0.8}, Interval{0, 1}, Interval{0.8, 1}));
  EXPECT_THAT(suite.studies.back().modes, ElementsAre(Mode::one_shot, Mode::point));
}

TEST(Reader, LeftOutKeysHaveTheirDefaults) {
  const Study study = parsed(minimal + "degree = [3]\n").studies.front();
  EXPECT_THAT(study.dimension, ElementsAre(2));
  EXPECT_THAT(study.coordinate_range, ElementsAre(1.0));
  EXPECT_THAT(study.t_interval, ElementsAre(Interval{0, 1}));
  EXPECT_THAT(study.generator, ElementsAre("continuous"));
  EXPECT_THAT(study.scalar, ElementsAre(ScalarKind::float64));
  EXPECT_THAT(study.baseline, ElementsAre("exact"));
  EXPECT_TRUE(study.methods.empty());
}

TEST(Reader, ATimingStudyWithoutModesHasAll) {
  const Study study = parsed(head + "kind = \"timing\"\ndegree = [3]\n").studies.front();
  EXPECT_EQ(study.modes.size(), 4U);
}

TEST(Reader, ATimingStudyMayHaveWhatItsProblemIsAsked) {
  EXPECT_TRUE(parsed(head + "kind = \"timing\"\npoints = [10]\n").studies.front().degree.empty());
  const Study study = parsed(head + "kind = \"timing\"\ndegree = [3]\norder = [1]\n").studies.front();
  EXPECT_THAT(study.order, ElementsAre(1));
  EXPECT_THAT(refused(head + "kind = \"timing\"\n"), HasSubstr("degree is missing"));
}

TEST(Reader, ARationalStudyWithoutGeneratorHasOneWithWeights) {
  EXPECT_THAT(parsed(minimal + "curve = \"rational\"\ndegree = [3]\n").studies.front().generator,
              ElementsAre("weights_mild"));
}

TEST(Reader, TakesWhatAGeneratorDrawsExactly) {
  const std::string exact = "generator = [\"multiple_root\"]\ncoordinate_range = [\"0x1p-900\", 0.25, \"0x1p900\"]\n";
  parsed(minimal + "degree = [0, 33]\n" + exact);
  parsed(minimal + "curve = \"polynomial\"\ndegree = [27]\n" + exact);
}

TEST(Reader, ReadsNumbersInEveryNotation) {
  const Study study = parsed(minimal +
                             "degree = [3, 0x4, 5]\ncoordinate_range = [\"0x1p-1022\", 2, \"1e-3\", -0.0e1]\n"
                             "t_interval = [[0, \"0x1p-1\"]]\ntrials = 10000\n")
                          .studies.front();
  EXPECT_THAT(study.degree, ElementsAre(3, 4, 5));
  EXPECT_THAT(study.coordinate_range, ElementsAre(0x1p-1022, 2.0, 1e-3, 0.0));
  EXPECT_FALSE(std::signbit(study.coordinate_range.back())) << "one zero only, or keys of cells would differ";
  EXPECT_THAT(study.t_interval, ElementsAre(Interval{0, 0.5}));
  EXPECT_EQ(study.trials, 10000);
}

TEST(Reader, OneBaselineNeedsNoBrackets) {
  EXPECT_THAT(parsed(minimal + "degree = [3]\nbaseline = \"direct\"\n").studies.front().baseline,
              ElementsAre("direct"));
}

TEST(Reader, ReadsChainsAndGlobs) {
  const auto conversion = parsed(head +
                                 "kind = \"conversion\"\ndegree = [3]\n"
                                 "methods = [\"factorial+forward_substitution+factorial\", \"*sum\"]\n");
  EXPECT_EQ(conversion.studies.front().methods.size(), 2U);
  EXPECT_EQ(parsed(minimal + "degree = [3]\nmethods = [\"*:horner\"]\n").studies.front().methods.size(), 1U);
}

struct Refusal {
  const char* text;      ///< follows `minimal`, from line 7
  const char* position;  ///< line and column
  const char* what;

  friend void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.what; }
};

class ReaderRefuses : public ::testing::TestWithParam<Refusal> {};

TEST_P(ReaderRefuses, WithPlaceAndAdvice) {
  const std::string line = refused(minimal + GetParam().text);
  EXPECT_THAT(line, StartsWith(std::string("x.toml:") + GetParam().position + ": "));
  EXPECT_THAT(line, HasSubstr(GetParam().what));
}

INSTANTIATE_TEST_SUITE_P(
    Studies, ReaderRefuses,
    ::testing::Values(
        Refusal{"degree = [3\n", "7:13", "not TOML"},                                                        //
        Refusal{"degre = [3]", "7:1", "did you mean \"degree\"?"}, Refusal{"", "4:1", "degree is missing"},  //
        Refusal{"degree = []", "7:10", "an array with a value"},
        Refusal{"degree = 3", "7:10", "degree must be an array"},
        Refusal{"degree = [3, 1024]", "7:14", "0 to 1023"},  //
        Refusal{"degree = [-1]", "7:11", "0 to 1023"}, Refusal{"degree = [99999999999]", "7:11", "0 to 1023"},
        Refusal{"degree = [3.5]", "7:11", "a whole number"}, Refusal{"degree = [3.0]", "7:11", "a whole number"},
        Refusal{"degree = [\"3\"]", "7:11", "a whole number"}, Refusal{"degree = [3, 4, 3]", "7:17", "twice"},
        Refusal{"degree = [3]\ndimension = [4]", "8:14", "1, 2 or 3"},
        Refusal{"degree = [3]\ndimension = [0]", "8:14", "1, 2 or 3"},
        Refusal{"degree = [3]\ncoordinate_range = [1, -1]", "8:24", "not negative"},
        Refusal{"degree = [3]\ncoordinate_range = [inf]", "8:21", "finite"},
        Refusal{"degree = [3]\ncoordinate_range = [\"nan\"]", "8:21", "finite"},
        Refusal{"degree = [3]\ncoordinate_range = [\"1 m\"]", "8:21", "a number"},
        Refusal{"degree = [3]\ncoordinate_range = [true]", "8:21", "a number"},
        Refusal{"degree = [3]\nt_interval = [[1, 0]]", "8:15", "a <= b"},
        Refusal{"degree = [3]\nt_interval = [[0, inf]]", "8:15", "finite"},
        Refusal{"degree = [3]\nt_interval = [0, 1]", "8:15", "[a, b]"},
        Refusal{"degree = [3]\nt_interval = [[0, 1, 2]]", "8:15", "[a, b]"},
        Refusal{"degree = [3]\ntrials = 0", "8:10", "at least 1"},
        Refusal{"degree = [3]\nreplicates = 0", "8:14", "at least 1"},
        Refusal{"degree = [3]\ngenerator = [\"continous\"]", "8:14", "did you mean \"continuous\"?"},
        Refusal{"degree = [3]\nmethods = [\"horner\", \"de_castlejau\"]", "8:22", "did you mean \"de_casteljau\"?"},
        Refusal{"degree = [3]\nmethods = [\"quux*\"]", "8:12", "no method matches \"quux*\""},
        Refusal{"degree = [3]\nmethods = [\"peer_gsl\"]", "8:12",
                "method \"peer_gsl\" is not in this build; configure with peers"},
        Refusal{"degree = [3]\nmethods = [\"direct\", \"peer_*\"]", "8:22", "\"peer_gsl\" is not in this build"},
        Refusal{"degree = [3]\nmethods = [\"*gsl\"]", "8:12", "no method matches \"*gsl\""},
        Refusal{"degree = [3]\nbaseline = \"peer_gsl\"", "8:12", "\"peer_gsl\" is not in this build"},
        Refusal{"degree = [3]\nmethods = []", "8:11", "leave the key out"},
        Refusal{"degree = [3]\nbaseline = \"exakt\"", "8:12", "did you mean \"exact\"?"},
        Refusal{"degree = [3]\nbaseline = [\"exact\", \"hornr\"]", "8:22", "did you mean \"horner\"?"},
        Refusal{"degree = [3]\nscalar = [\"single\"]", "8:11", "float, double"},
        Refusal{"degree = [3]\ncurve = \"bernstien\"", "8:9", "did you mean \"bernstein\"?"},
        Refusal{"degree = [3]\nmodes = [\"batch\"]", "8:1",
                "kind \"accuracy\" does not have the key modes; kind timing has it; remove it"},
        Refusal{"degree = [3]\npoints = [10]", "8:1",
                "does not have the key points; kinds timing, interpolation, fitting, grid have it; remove it"},
        Refusal{"degree = [3]\n[[study]]\nid = \"b\"\nkind = \"interpolation\"", "8:1",
                "points is missing; kind \"interpolation\" needs it, add points = [10, 100]"},
        Refusal{"degree = [3]\n[[study]]\nid = \"b\"\nkind = \"interpolation\"\npoints = [3, 1]", "11:14", "2 to"},
        Refusal{"degree = [3]\n[[study]]\nid = \"b\"\nkind = \"interpolation\"\npoints = [3]\ndegree = [3]", "12:1",
                "does not have the key degree: degree is that of the segments, 3; kinds accuracy, "},
        Refusal{"degree = [3]\n[[study]]\nid = \"b\"\nkind = \"timing\"\ndegree = [3]\nmodes = [\"bach\"]", "12:10",
                "did you mean \"batch\"?"},
        Refusal{"degree = [3]\npublished = \"report_table.csv\"", "8:13", "did you mean \"report_tables.csv\"?"},
        Refusal{"degree = [3]\ntrials = 9223372036854775807\nreplicates = 2", "9:14", "below 2^63"},
        Refusal{"degree = [3]\ngenerator = [\"report\"]\nt_interval = [[-1e308, 1e308]]", "9:15", "narrow"},
        Refusal{"degree = [3]\ntitle = 3", "8:9", "a string"},
        Refusal{"degree = [3]\ngenerator = [\"integer\"]\ncoordinate_range = [1, 0.5]", "9:24", "from 1 to 2^53"},
        Refusal{"degree = [3]\ncoordinate_range = [1.7e308]", "8:21", "needs a coordinate_range from 0 to 2^1020, not"},
        Refusal{"degree = [3]\ngenerator = [\"integer\"]\ncoordinate_range = [1e16]", "9:21", "from 1 to 2^53"},
        Refusal{"degree = [3]\ncurve = \"rational\"\ngenerator = [\"weights_wild\", \"dyadic\"]", "9:30",
                "generator \"dyadic\" draws no weights, which rational curves need; use weights_mild, weights_wild"},
        Refusal{"degree = [3]\ngenerator = [\"weights_mild\"]", "8:14",
                "generator \"weights_mild\" draws weights, which only rational curves have; use continuous, dyadic"},
        Refusal{"degree = [33, 34]\ngenerator = [\"multiple_root\"]", "7:15",
                "curves in bernstein form up to degree 33 only"},
        Refusal{"degree = [28]\ncurve = \"polynomial\"\ngenerator = [\"continuous\", \"multiple_root\"]", "7:11",
                "curves in power form up to degree 27 only"},
        Refusal{"degree = [3]\ngenerator = [\"multiple_root\"]\ncoordinate_range = [2, 3]", "9:24",
                "a power of two from 2^-900 to 2^900, not 3; change"},
        Refusal{"degree = [3]\ngenerator = [\"multiple_root\"]\ncoordinate_range = [\"0x1p901\"]", "9:21",
                "a power of two from"},
        Refusal{"degree = [3]\ngenerator = [\"multiple_root\"]\ncoordinate_range = [0]", "9:21", "a power of two from"},
        Refusal{"degree = [3]\ngenerator = [\"multiple_root\"]\nscalar = [\"double\", \"float\"]", "9:21",
                "exact in double only"},
        Refusal{"degree = [3]\nscalar = [\"float\"]\ncoordinate_range = [1e39]", "9:21", "largest float"},
        Refusal{"curves = [\"a.svg\"]\ncoordinate_range = [1]", "8:1",
                "coordinate_range is for drawn curves, and these are those of sets; remove it"},
        Refusal{"curves = [\"a.svg\"]\ntrials = 10", "8:1", "trials is for drawn curves"},
        Refusal{"degree = [3]\nparameters = 10", "8:1",
                "parameters is for curves of sets; remove it, or name sets in curves"},
        Refusal{"curves = [\"a.svg\", \"#b\"]", "7:20", "an entry without a set"},
        Refusal{"curves = [\"a.svg\", \"a.svg\"]", "7:20", "curves has this value twice"},
        Refusal{"curves = [\"a.svg\"]\nparameters = -1", "8:14", "parameters must be 1 to 1048576"},
        Refusal{"curves = [\"a.svg\"]\nparameters_from = \"grid\"", "8:19",
                "must be 2 to 1048576, since a grid has both ends"},
        Refusal{"curves = [\"a.svg\"]\nparameters_from = \"stored\"\nparameters = 3", "9:14",
                "those of the set; leave parameters out"},
        Refusal{"curves = [\"a.svg\"]\ncurves_sha256 = [\"1\", \"2\"]", "8:1", "one value for each of curves"},
        Refusal{"curves = [\"a.svg\"]\nplacement = [\"moved\"]", "8:14", "unknown placement \"moved\""},
        Refusal{"degree = [3]\n[[study]]\nid = \"a\"\nkind = \"accuracy\"\ndegree = [3]", "9:6", "another study"},
        Refusal{"degree = [3]\n[[study]]\nid = \"a,b\"\nkind = \"accuracy\"\ndegree = [3]", "9:6", "letters"},
        Refusal{"degree = [3]\n[[study]]\nkind = \"accuracy\"\ndegree = [3]", "8:1", "id is missing"},
        Refusal{"degree = [3]\n[[study]]\nid = \"b\"\ndegree = [3]", "8:1", "kind is missing"},
        Refusal{"degree = [3]\n[[study]]\nid = \"b\"\nkind = \"acuracy\"", "10:8", "did you mean \"accuracy\"?"},
        Refusal{"degree = [3]\n[[study]]\nid = \"b\"\nkind = \"conversion\"\ndegree = [3]\n"
                "methods = [\"factorial+forward+factorial\"]",
                "12:12", "unknown conversion \"forward\""}));

TEST(Reader, RefusesMoreCellsThanMemoryHolds) {
  const auto numbers = [](int count) {
    std::string list = "0";
    for (int k = 1; k < count; ++k) list += ", " + std::to_string(k);
    return "[" + list + "]";
  };
  const auto axes = [&](int ranges) {
    return minimal + "degree = " + numbers(1000) + "\ncoordinate_range = " + numbers(ranges) + "\n";
  };
  EXPECT_EQ(parsed(axes(1000)).studies.front().coordinate_range.size(), 1000U);
  EXPECT_THAT(refused(axes(1001)), HasSubstr("the axes give 1001000 cells, more than 1000000"));
}

TEST(Reader, RefusesASeedOutOfRange) {
  const auto with_seed = [](const std::string& seed) {
    return "schema_version = 1\n[suite]\nid = \"s\"\nseed = " + seed +
           "\n[[study]]\nid = \"a\"\nkind = \"accuracy\"\ndegree = [3]\n";
  };
  EXPECT_EQ(parsed(with_seed("9223372036854775807")).seed, 9223372036854775807U);
  EXPECT_EQ(parsed(with_seed("0")).seed, 0U);
  EXPECT_THAT(refused(with_seed("-1")), StartsWith("x.toml:4:8: seed must be 0 to 2^63-1"));
  EXPECT_THAT(refused(with_seed("9223372036854775808")), StartsWith("x.toml:4:"));
  EXPECT_THAT(refused(with_seed("\"x\"")), StartsWith("x.toml:4:8: seed must be a whole number"));
}

TEST(Reader, RefusesDocumentsThatAreNoSuite) {
  EXPECT_THAT(refused(""), HasSubstr("schema_version is missing"));
  EXPECT_THAT(refused("schema_version = 2\n"), StartsWith("x.toml:1:18: schema_version must be 1"));
  EXPECT_THAT(refused("schema_version = \"1\"\n"), HasSubstr("schema_version must be 1"));
  EXPECT_THAT(refused("schema_version = 1\n"), HasSubstr("[suite] is missing"));
  EXPECT_THAT(refused("schema_version = 1\n[suite]\nid = \"s\"\n"), HasSubstr("no study"));
  EXPECT_THAT(refused("schema_version = 1\nstudy = []\n[suite]\nid = \"s\"\n"), HasSubstr("no study"));
  EXPECT_THAT(refused("schema_version = 1\nstudy = 3\n[suite]\nid = \"s\"\n"), HasSubstr("[[study]]"));
  EXPECT_THAT(refused("schema_version = 1\nsuite = 3\n"), StartsWith("x.toml:2:9: suite must be a table"));
  EXPECT_THAT(refused("schema_version = 1\n[suit]\n"), HasSubstr("did you mean \"suite\"?"));
  EXPECT_THAT(refused("schema_version = 1\n[suite]\nidd = \"s\"\n"), StartsWith("x.toml:3:1: unknown key \"idd\""));
  EXPECT_THAT(refused("schema_version = 1\n[suite]\ntitle = \"s\"\n"), HasSubstr("id is missing"));
}

TEST(Reader, AnUnreadableFileIsAUsageError) {
  const auto missing = failure_of([] { read_suites("no/such/suite.toml", test_vocabulary()); });
  EXPECT_THAT(missing, StartsWith("no/such/suite.toml: cannot be read (No such file or directory); "));
  const auto folder = failure_of([] { read_suites(BEZIERBENCH_SOURCE_DIR, test_vocabulary()); });
  EXPECT_THAT(folder, HasSubstr(": cannot be read (Is a directory); "));
}

TEST(Reader, IdsAreUniqueOverABundle) {
  std::vector<Suite> suites(2, parsed(minimal + "degree = [3]\n"));
  const auto refusal = [&] { return failure_of([&] { check_unique_ids(suites, "b.toml"); }); };
  EXPECT_EQ(refusal(), "b.toml: another suite has the id \"s\" too; rename one");
  suites[1].id = "other";
  EXPECT_THAT(refusal(), HasSubstr("b.toml: study \"a\" is in suite \"s\" and in suite \"other\""));
  suites[1].studies[0].id = "b";
  EXPECT_EQ(refusal(), "");
}

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
    for (std::size_t j = 0; j < a[i].studies.size(); ++j)
      EXPECT_TRUE(equal(a[i].studies[j], b[i].studies[j])) << a[i].studies[j].id;
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
      for (std::size_t j = 0; j <= below(3); ++j)
        made[i].studies.push_back(study(std::to_string(i) + "." + std::to_string(j)));
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
  const auto suites = read_suites(BEZIERBENCH_SOURCE_DIR "/experiments/suites/report.toml", test_vocabulary());
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

}  // namespace
}  // namespace bezierbench::suite
