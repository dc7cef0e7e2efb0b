// SPDX-License-Identifier: MIT
#include "experiments/bundle/digest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/bundle/scratch_folder_test.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

// FIPS 180-4 examples.
constexpr std::string_view of_nothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
constexpr std::string_view of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(Digest, Sha256OfKnownTexts) {
  EXPECT_EQ(sha256_hex(""), of_nothing);
  EXPECT_EQ(sha256_hex("abc"), of_abc);
  EXPECT_NE(sha256_hex(std::string_view("a\0b", 3)), sha256_hex("a"));
}

TEST(Digest, AbsentFileAndUnprintableNameFail) {
  const ScratchFolder folder;
  const std::vector<std::string> names{"absent.csv"};
  EXPECT_THROW((void)sha256sums(folder.path(), names), Failure);
  EXPECT_THROW((void)sha256sum_line("a\nb", ""), Failure);
  EXPECT_THROW((void)sha256sum_line("a\\b", ""), Failure);
}

using testing::Contains;
using testing::ElementsAre;

const DeclaredTable& accuracy() { return *declared_table("accuracy.csv"); }

std::vector<MethodDigest> digests(std::string_view text, const std::vector<std::string>& columns) {
  return method_digests(accuracy(), parse_csv(text, "accuracy.csv"), columns);
}

constexpr auto three_rows =
    "study,method,degree,max_error\n"
    "s,direct,3,1e-17\n"
    "s,horner,3,2e-17\n"
    "s,direct,4,3e-17\n";

TEST(MethodDigest, IsOfTheRowsOfOneMethodInOneStudyAsACsvFile) {
  EXPECT_THAT(digests(three_rows, {"method", "max_error"}),
              ElementsAre(
                  MethodDigest{
                      {"accuracy.csv", "s", "direct"}, 2, sha256_hex("method,max_error\ndirect,1e-17\ndirect,3e-17\n")},
                  MethodDigest{{"accuracy.csv", "s", "horner"}, 1, sha256_hex("method,max_error\nhorner,2e-17\n")}));
}

TEST(MethodDigest, OfDigestedColumnsOnly) {
  EXPECT_THAT(accuracy().digested(), Contains("unbounded_trials"));
  EXPECT_THAT(declared_table("worst.csv")->digested(), testing::Not(Contains("worst_id")));
  EXPECT_THROW((void)digests(three_rows, {"unbounded_trials"}), Failure);
}

TEST(MethodDigest, AreReadBackFromTheirTable) {
  const auto all = digests(three_rows, {"degree"});
  EXPECT_EQ(parse_digests(parse_csv(digests_csv(all), digests_name)), all);
  EXPECT_THROW((void)parse_digests(parse_csv("table,study,method,rows,digest\na,b,c,-1,d\n", digests_name)), Failure);
}

}  // namespace
}  // namespace bezierbench::bundle
