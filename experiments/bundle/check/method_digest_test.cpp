// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/method_digest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/scratch_folder_test.hpp"
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

TEST(MethodDigest, OfABundleAreOfItsDeterministicTablesSortedByName) {
  const ScratchFolder folder;
  const auto fill = [&](const std::string& name, const std::string& study, const std::string& method) {
    std::string header;
    std::string row;
    for (const auto& column : declared_table(name)->header()) {
      header += (header.empty() ? "" : ",") + column;
      row += std::string(row.empty() ? "" : ",") + (column == study ? "s" : column == method ? "m" : "1");
    }
    folder.put(name, header + "\n" + row + "\n");
  };
  std::vector<std::string> expected;
  for (const auto& table : declared_tables()) {
    fill(table.file, table.study, table.method);
    if (table.is_deterministic) expected.push_back(table.file);
  }
  std::ranges::sort(expected);
  std::vector<std::string> found;
  for (const auto& [rows_of, count, digest] : digests_of(folder.path())) {
    EXPECT_EQ(rows_of.study, "s");
    EXPECT_EQ(rows_of.method, "m");
    found.push_back(rows_of.table);
  }
  EXPECT_EQ(found, expected);
}

TEST(AccuracyDigest, UnreadableDeterministicFileDoesNotCountAsAbsent) {
  const ScratchFolder folder;
  std::filesystem::create_symlink("nowhere", folder.path() / "accuracy.csv");
  EXPECT_THROW((void)accuracy_digest(folder.path()), Failure);
}

}  // namespace
}  // namespace bezierbench::bundle
