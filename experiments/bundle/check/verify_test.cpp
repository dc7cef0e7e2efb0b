// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/verify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <stdexcept>
#include <string>

#include "experiments/bundle/scratch_folder_test.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto place = text.find(from);
  if (place == std::string::npos) throw std::invalid_argument("nothing to replace: " + from);
  return text.replace(place, from.size(), to);
}

class Verify : public testing::Test {
 protected:
  Verify() : bundle_(filled(folder_.path() / "b")) { finish(bundle_, with_state("complete")); }

  void put(const std::string& name, std::string_view bytes) { folder_.put("b/" + name, bytes); }
  void remove(const std::string& name) { fs::remove(bundle_.path() / name); }
  /// Without methods.csv no row accuses a method that may promise nothing.
  void add_promising_methods() {
    bundle_.write("methods.csv",
                  "id,problem,form,min_degree,max_degree,bound,bit_stable,flops,citation,guarantees\n"
                  "direct,evaluation,bernstein,0,170,a bound,yes,,a source,\n");
  }
  /// Changes the content of a file and its checksum with it.
  void change(const std::string& name, const std::string& from, const std::string& to) {
    bundle_.write(name, replaced(bundle_.read(name), from, to));
    finish(bundle_, with_state("complete"));
  }
  [[nodiscard]] std::vector<std::string> findings() const { return verify(bundle_.path(), expected); }

  ScratchFolder folder_;
  BundleDirectory bundle_;
};

TEST_F(Verify, AGoodBundle) { EXPECT_THAT(findings(), IsEmpty()); }

TEST_F(Verify, ChangedNoisyFile) {
  put("timing.csv", replaced(bundle_.read("timing.csv"), "\nfixture", "\r\nfixture"));
  EXPECT_THAT(findings(), ElementsAre(EndsWith("timing.csv: checksum differs from SHA256SUMS")));
}

TEST_F(Verify, ChangedDeterministicFileShowsInTheDigestToo) {
  put("accuracy.csv", replaced(bundle_.read("accuracy.csv"), ",100,", ",101,"));
  EXPECT_THAT(findings(), ElementsAre(EndsWith("method direct: its rows give another digest"),
                                      EndsWith("accuracy.csv: checksum differs from SHA256SUMS")));
}

class VerifyMethods : public Verify {
 protected:
  void replace(const std::string& name, const std::string& from, const std::string& to) {
    folder_.put("b/" + name, replaced(bundle_.read(name), from, to));
  }
  /// The findings without those about checksums.
  [[nodiscard]] std::vector<std::string> findings() const {
    auto all = verify(bundle_.path(), expected);
    std::erase_if(all, [](const std::string& one) { return one.ends_with("checksum differs from SHA256SUMS"); });
    return all;
  }
};

TEST_F(VerifyMethods, ARowThatChangedIsNamedByTableStudyAndMethod) {
  EXPECT_THAT(findings(), IsEmpty());
  replace("accuracy.csv", "fixture-accuracy,bernstein,de_casteljau,double,2,3,",
          "fixture-accuracy,bernstein,de_casteljau,double,2,4,");
  EXPECT_THAT(findings(),
              ElementsAre(EndsWith("digests.csv: accuracy.csv, study fixture-accuracy, method de_casteljau: "
                                   "its rows give another digest")));
}

TEST_F(VerifyMethods, LinesThatAreMissingOrOfNoRows) {
  replace("digests.csv", ",direct,", ",nobody,");
  EXPECT_THAT(findings(),
              ElementsAre(HasSubstr("bundle.json: accuracy_digest is "), EndsWith("method direct: has no line"),
                          EndsWith("method nobody: has no such rows")));
  replace("digests.csv", ",nobody,", ",direct,");
  folder_.put("b/digests.csv", bundle_.read("digests.csv") + "\n");
  EXPECT_THAT(findings(), Contains(HasSubstr("digests.csv")));
  fs::remove(bundle_.path() / "digests.csv");
  EXPECT_THAT(findings(), Contains(EndsWith("digests.csv: is missing")));
}

TEST_F(Verify, MissingFiles) {
  remove("timing.csv");
  remove("machine.json");
  EXPECT_THAT(findings(), ElementsAre(EndsWith("machine.json: is missing"),
                                      EndsWith("timing.csv: is listed in SHA256SUMS and is missing")));
  remove("bundle.json");
  EXPECT_THAT(findings(), Contains(EndsWith("bundle.json: is missing")));
}

TEST_F(Verify, UnknownFilesFoldersAndLeftovers) {
  put("notes.txt", "x");
  put("folder/x", "x");
  put("blocks/x", "x");
  put(".bezierbench-1-2.tmp", "x");
  fs::create_symlink("accuracy.csv", bundle_.path() / "link.csv");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("notes.txt: does not belong"), HasSubstr("interrupted write"),
                                      HasSubstr("b/blocks: left"), HasSubstr("b/folder: "), HasSubstr("b/link.csv: ")));
}

TEST_F(Verify, ListedFilesThatNoBundleHas) {
  put("other.csv", "a\n1\n");
  finish(bundle_, with_state("complete"));
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("other.csv: does not belong to a bundle")));
}

TEST_F(Verify, AFolderThatIsNoBundleIsOneLine) {
  for (const char* name : {"thesis/a.tex", "thesis/b.tex", "thesis/blocks/c", "iso/SHA256SUMS", "iso/d"})
    folder_.put(name, "x");
  for (const char* name : {"thesis", "iso"})
    EXPECT_THAT(verify(folder_.path() / name, expected), ElementsAre(HasSubstr("is not a bundle; give a folder that")));
}

TEST_F(Verify, DamagedManifest) {
  put("bundle.json", "{\"schema_version\": 1");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("malformed JSON"), EndsWith("bundle.json: checksum differs from "
                                                                            "SHA256SUMS")));
}

TEST_F(Verify, RefusesABundleOfAnEarlierSchemaVersion) {
  put("bundle.json", replaced(bundle_.read("bundle.json"), "\"schema_version\": 3", "\"schema_version\": 2"));
  try {
    (void)findings();
    ADD_FAILURE();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::usage);
    EXPECT_THAT(failure.what(), HasSubstr("the last that reads it"));
  }
}

TEST_F(Verify, ManifestOfAnotherSuite) {
  Manifest other = with_state("complete");
  other.suite_digest = std::string(64, '0');
  other.seed = 2;
  other.suites = {"another"};
  finish(bundle_, other);
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("its digest of suites is 000"), HasSubstr("seed is 2, in suite.toml 1"),
                                      HasSubstr("its suites are not those")));
}

TEST_F(Verify, SuiteThatDoesNotRead) {
  EXPECT_THAT(
      verify(bundle_.path(),
             [](const auto&, const std::string& file) -> Expected { throw Failure(Exit::usage, file + ":1:1: what"); }),
      ElementsAre(HasSubstr("suite.toml:1:1: what")));
}

TEST_F(Verify, CutOrDoubledSums) {
  const std::string sums = bundle_.read("SHA256SUMS");
  put("SHA256SUMS", std::string_view(sums).substr(0, sums.size() - 1));
  EXPECT_THAT(findings(), Contains(HasSubstr("SHA256SUMS:6: ")));
  put("SHA256SUMS", sums + sums.substr(0, sums.find('\n') + 1));
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("SHA256SUMS:7: ")));
}

TEST_F(Verify, TableThatIsNotCsv) {
  bundle_.write("audit.csv", "a,b\n1\n");
  finish(bundle_, with_state("complete"));
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("audit.csv:2: row has 1 field")));
}

TEST_F(Verify, ManyRowsThatAccuseAreAFewLines) {
  add_promising_methods();
  const auto table = bundle_.read("timing.csv");
  const auto row = replaced(table.substr(table.find('\n') + 1), ",ok,yes", ",ok,no");
  std::string many = table;
  for (int k = 0; k < 100; ++k) many += row.substr(0, row.find('\n') + 1);
  bundle_.write("timing.csv", many);
  finish(bundle_, with_state("complete"));
  EXPECT_THAT(findings(), AllOf(SizeIs(6), Contains(HasSubstr("95 more of that kind"))));
}

TEST_F(Verify, RowsThatAccuse) {
  add_promising_methods();
  change("timing.csv", ",ok,yes", ",ok,no");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("timing.csv:2: what was timed did not give what was judged")));
  change("timing.csv", ",ok,no", ",ok,yes");
  change("timing.csv", "\nfixture-timing,", "\nother,");
  EXPECT_THAT(findings(), ElementsAre(HasSubstr("timing.csv:2: its study is not one of those of suite.toml")));
}

/// Only regular files are opened: opening these would block for ever or fill the memory.
TEST_F(Verify, PipesAndLinks) {
  remove("timing.csv");
  ASSERT_EQ(mkfifo((bundle_.path() / "timing.csv").c_str(), 0600), 0);
  remove("accuracy.csv");
  fs::create_symlink("/dev/zero", bundle_.path() / "accuracy.csv");
  EXPECT_THAT(findings(), AllOf(Contains(HasSubstr("timing.csv: does not belong")),
                                Contains(HasSubstr("accuracy.csv: does not belong"))));
  remove("bundle.json");
  fs::create_symlink("/dev/zero", bundle_.path() / "bundle.json");
  EXPECT_THAT(findings(), Contains(HasSubstr("bundle.json: is missing")));
}

TEST_F(Verify, NoFolder) { EXPECT_THROW((void)verify(folder_.path() / "absent", expected), Failure); }

std::vector<std::string> faults(const std::string& file, const std::string& text) {
  return row_faults(file, parse_csv(text, file), {.promising = {"a"}, .external = {"own"}});
}

TEST(RowRules, BrokenPromisesAccuseEverywhereAndMissedFeetThoseThatPromise) {
  for (const char* file :
       {"projection.csv", "arc_length.csv", "inverse_arc_length.csv", "fitting.csv", "subdivision.csv"})
    EXPECT_THAT(faults(file, "method,broken_promises\na,2\nb,0\n"),
                ElementsAre(std::string(file) + ":2: 2 broken promises"));
  EXPECT_THAT(faults("accuracy.csv", "method,bound_violations\na,3\nb,0\n"),
              ElementsAre("accuracy.csv:2: 3 bound violations"));
  EXPECT_THAT(faults("subdivision.csv", "method,points_off\na,1\nb,0\n"),
              ElementsAre("subdivision.csv:2: 1 points of a half off the curve"));
  EXPECT_THAT(faults("projection.csv", "method,missed\na,1\nown,1\nb,1\n"),
              ElementsAre("projection.csv:2: 1 missed foot points"));
  EXPECT_THAT(faults("timing.csv", "method,checked\na,yes\nb,no\nown,no\n"),
              ElementsAre("timing.csv:4: what was timed did not give what was judged"));
}

}  // namespace
}  // namespace bezierbench::bundle
