// SPDX-License-Identifier: MIT
#include "experiments/suite/kind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/vocabulary_test.hpp"

namespace bezierbench::suite {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string head = "schema_version = 1\n[suite]\nid = \"s\"\n[[study]]\n";  // four lines

std::string example_of(const Kind& kind, const Field& field) {
  if (field.key == "kind") return "\"" + std::string(kind.id) + "\"";
  return std::string(field.key == "methods" ? kind.methods_example : field.example);
}

/// A study with the keys that its kind requires, followed by `more`. A required key that is in `more` is written only
/// there.
std::string study_of(const Kind& kind, const std::string& more = {}) {
  std::string text = head;
  for (const Field* field : fields_of(kind)) {
    const bool wanted =
        is_required(kind, *field) || (field->key == "degree" && kind.inputs.degree == DegreeUse::optional);
    if (wanted && !more.starts_with(std::string(field->key) + " ="))
      text += std::string(field->key) + " = " + example_of(kind, *field) + "\n";
  }
  return text + more;
}

Study parsed(const std::string& text) {
  return parse_suites(text, "x.toml", test_vocabulary()).front().studies.front();
}

std::string refused(const std::string& text) {
  return failure_of([&] { parsed(text); });
}

/// The place of the last line of `text`, at `column`.
std::string last_line(const std::string& text, int column = 1) {
  return "x.toml:" + std::to_string(std::count(text.begin(), text.end(), '\n') + 1) + ":" + std::to_string(column) +
         ": ";
}

std::string line_of(const Kind& kind, const Field& field) {
  return std::string(field.key) + " = " + example_of(kind, field);
}

TEST(Kinds, HaveIdsAndDescriptions) {
  std::set<std::string_view> seen;
  for (const Kind* kind : studies::kinds()) {
    EXPECT_TRUE(seen.insert(kind->id).second) << kind->id;
    EXPECT_EQ(&studies::kind(kind->id), kind);
    EXPECT_FALSE(kind->about.empty());
    EXPECT_EQ(&kind_of(parsed(study_of(*kind))), kind);
    for (const Field* field : fields_of(*kind)) {
      EXPECT_FALSE(field->meaning.empty()) << field->key;
      Study study;
      study.kind = kind;
      const bool has_default = !to_text(*field, study).empty();
      EXPECT_TRUE(has_default || is_required(*kind, *field) || !field->left_out.empty())
          << kind->id << " " << field->key;
    }
  }
}

TEST(Kinds, TakeTheExamplesOfTheirKeysAndWriteThemBack) {
  for (const Kind* kind : studies::kinds())
    for (const Field* field : fields_of(*kind)) {
      auto text = study_of(*kind, line_of(*kind, *field));
      const bool alone =
          field->curves != Curves::of_sets || field->key == "curves" || kind->inputs.sets == SetUse::required;
      if (!alone) text += "\ncurves = [\"outlines.svg\"]";
      SCOPED_TRACE(text);
      ASSERT_EQ(refused(text), "");
      const Study study = parsed(text);
      EXPECT_FALSE(is_empty(*field, study));
      const std::vector<Suite> suites{{"s", "", 1, {study}}};
      const Study back = parsed(to_toml(suites));
      for (const Field* other : fields_of(*kind)) EXPECT_EQ(to_text(*other, back), to_text(*other, study));
      EXPECT_EQ(to_toml(suites), to_toml(std::vector<Suite>{{"s", "", 1, {back}}}));
    }
}

/// The refusal points to the key and names the kinds that have it.
TEST(Kinds, RefuseKeysOfOtherKinds) {
  int refusals = 0;
  for (const Kind* kind : studies::kinds())
    for (const Kind* other : studies::kinds())
      for (const Field* field : fields_of(*other)) {
        if (find_field(*kind, field->key) != nullptr) continue;
        const auto text = study_of(*kind, line_of(*other, *field));
        const auto line = refused(text);
        EXPECT_THAT(line, StartsWith(last_line(text) + "kind \"" + std::string(kind->id) + "\" does not have the key " +
                                     std::string(field->key)));
        EXPECT_THAT(line, HasSubstr(std::string(other->id)));
        EXPECT_THAT(line, HasSubstr("; remove it"));
        ++refusals;
      }
  EXPECT_GT(refusals, 100);
}

/// The refusal points to the header of the study.
TEST(Kinds, RefuseStudiesWithoutAKeyThatTheyNeed) {
  for (const Kind* kind : studies::kinds())
    for (const Field* field : fields_of(*kind)) {
      if (!is_required(*kind, *field)) continue;
      auto text = study_of(*kind);
      const auto line = line_of(*kind, *field) + "\n";
      text.erase(text.find(line), line.size());
      EXPECT_THAT(refused(text), StartsWith("x.toml:4:1: " + std::string(field->key) + " is missing")) << kind->id;
    }
}

TEST(Kinds, RefuseValuesOfAnotherType) {
  for (const Kind* kind : studies::kinds())
    for (const Field* field : fields_of(*kind)) {
      const auto text = study_of(*kind, std::string(field->key) + " = true");
      EXPECT_THAT(refused(text), StartsWith(last_line(text, static_cast<int>(field->key.size()) + 4))) << kind->id;
    }
}

struct Refusal {
  std::string_view kind;
  std::string more;
  int column;
  const char* what;
};

TEST(Kinds, RefuseInputsThatTheyDoNotTake) {
  for (const auto& [kind, more, column, what] :
       {Refusal{"fitting", "curve = \"rational\"", 9,
                "data are taken from polynomial Bezier curves; write curve = \"bernstein\""},
        Refusal{"conversion", "curve = \"rational\"", 9, "conversions take polynomial curves"},
        Refusal{"arc_length", "curve = \"polynomial\"", 9, "write curve = \"bernstein\""},
        Refusal{"subdivision", "curve = \"polynomial\"", 9, "what is split has control points"},
        Refusal{"projection", "curve = \"polynomial\"", 9, "write curve = \"bernstein\""},
        Refusal{"derivative", "scalar = [\"double\", \"float\"]", 21,
                "kind \"derivative\" is computed in double only; leave scalar out"},
        Refusal{"conversion", "scalar = [\"float\"]", 11, "in double only"},
        Refusal{"inverse_arc_length", "t_interval = [[0, 1], [-1, 1]]", 23,
                "t_interval -1:1 is the share of the length at which t is sought and must be within 0 and 1"},
        Refusal{"interpolation", "t_interval = [[0, 0.5]]", 15, "points are joined whole; leave t_interval out"},
        Refusal{"fitting", "t_interval = [[0, 0.5]]", 15, "whole curves; leave t_interval out"},
        Refusal{"fitting", "degree = [3, 0]", 14, "degree 1 or more; remove the degree 0"},
        Refusal{"projection", "generator = [\"continuous\", \"multiple_root\"]", 28,
                "draws a curve as a whole, not points"},
        Refusal{"fitting", "baseline = \"de_casteljau\"", 1, "measures against the exact value only"},
        Refusal{"fitting", "tolerance = [1e-3, 0]", 20, "finite and above 0"},
        Refusal{"derivative", "order = [1, 1]", 13, "twice"},
        Refusal{"accuracy", "decomposed_trials = -1", 21, "not be negative"},
        Refusal{"hard_cases", "kept = 1001", 8, "kept must be 1 to 1000"},
        Refusal{"guarantees", "budget = -1", 10, "at least 1"},
        Refusal{"search", "budget = -1", 10, "at least 1"},
        Refusal{"timing", "points = [1]", 11, "points must be 2 to"}}) {
    const auto text = study_of(studies::kind(kind), more);
    EXPECT_THAT(refused(text), StartsWith(last_line(text, column))) << more;
    EXPECT_THAT(refused(text), HasSubstr(what));
  }
}

const Kind& judged(Problem problem) {
  return **std::ranges::find(studies::kinds(), std::optional(problem), &Kind::problem);
}

std::string timed(const std::string& more, Problem problem) {
  const Study study = parsed(head + "id = \"a\"\nkind = \"timing\"\n" + more);
  const auto fault = check_timed(study, judged(problem), test_vocabulary().generators);
  return fault ? failure_of([&] { refuse(study, *fault); }) : "";
}

TEST(Kinds, TimedProblemsNeedTheAxesOfTheirKindAndTakeItsInputs) {
  const std::string one = "modes = [\"one_shot\"]\n";
  EXPECT_EQ(timed("degree = [3]\n", Problem::evaluation), "");
  EXPECT_EQ(timed(one + "degree = [3]\norder = [1]\n", Problem::derivative), "");
  EXPECT_EQ(timed(one + "points = [10]\n", Problem::interpolation), "");
  EXPECT_EQ(timed("degree = [3]\norder = [1]\n", Problem::evaluation),
            "x.toml:8:1: study \"a\": the problem evaluation does not have the key order; remove it");
  EXPECT_THAT(timed(one + "degree = [3]\n", Problem::derivative),
              StartsWith("x.toml:4:1: study \"a\": the problem derivative requires the key order; add it"));
  EXPECT_THAT(timed(one + "degree = [3]\npoints = [10]\n", Problem::interpolation),
              StartsWith("x.toml:8:1: study \"a\": the problem interpolation does not have the key degree; remove it"));
  EXPECT_THAT(timed("degree = [3]\nmodes = [\"point\"]\n", Problem::projection),
              StartsWith("x.toml:8:10: study \"a\": a companion problem is timed from the control points on; write"));
  EXPECT_THAT(timed(one + "degree = [3]\nscalar = [\"float\"]\n", Problem::projection),
              StartsWith("x.toml:9:11: study \"a\": the problem projection is computed in double only"));
}

/// A study that was not read from a file has no place.
TEST(Faults, SayWhereTheyAre) {
  Study study;
  study.id = "a";
  const Fault fault{"degree", 1, "generator", "is wrong"};
  const auto line = [&](const Fault& what) { return failure_of([&] { refuse(study, what); }); };
  EXPECT_EQ(line(fault), "study \"a\": is wrong");
  study.places = {"x.toml", {4, 1}, {}, {}};
  EXPECT_EQ(line(fault), "x.toml:4:1: study \"a\": is wrong");
  study.places.keys["generator"] = {{6, 1}, {6, 13}, {}};
  EXPECT_EQ(line(fault), "x.toml:6:13: study \"a\": is wrong");
  study.places.keys["degree"] = {{5, 1}, {5, 10}, {{5, 11}, {5, 14}}};
  EXPECT_EQ(line(fault), "x.toml:5:14: study \"a\": is wrong");
  EXPECT_EQ(line({"degree", 9, {}, "is wrong"}), "x.toml:5:10: study \"a\": is wrong");
  EXPECT_EQ(line({"degree", Fault::key_itself, {}, "is wrong"}), "x.toml:5:1: study \"a\": is wrong");
  study.places.options["generator"] = "--set generator=integer";
  EXPECT_EQ(line(fault), "--set generator=integer: study \"a\": is wrong");
}

}  // namespace
}  // namespace bezierbench::suite
