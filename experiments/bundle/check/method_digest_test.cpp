// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/method_digest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/bundle/digest.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsSupersetOf;

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

TEST(MethodDigest, OfAMethodThatIsAddedChangesNoOther) {
  const auto before = digests(three_rows, {"degree", "max_error"});
  const auto after = digests(
      "study,method,degree,max_error\n"
      "s,new,3,9e-17\n"
      "s,direct,3,1e-17\n"
      "s,horner,3,2e-17\n"
      "s,new,4,9e-17\n"
      "s,direct,4,3e-17\n"
      "t,direct,4,3e-17\n",
      {"degree", "max_error"});
  EXPECT_EQ(after.size(), before.size() + 2);
  EXPECT_THAT(after, IsSupersetOf(before));
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
