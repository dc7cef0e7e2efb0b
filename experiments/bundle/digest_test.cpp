// SPDX-License-Identifier: MIT
#include "experiments/bundle/digest.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
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

TEST(Digest, SumsAreSortedLinesThatCoreutilsChecks) {
  const ScratchFolder folder;
  folder.put("b.csv", "abc");
  folder.put("a.csv", "");
  folder.put("Z.csv", "abc");
  const std::vector<std::string> names{"b.csv", "a.csv", "Z.csv"};
  const std::string sums = sha256sums(folder.path(), names);
  EXPECT_EQ(sums, std::string(of_abc) + "  Z.csv\n" + std::string(of_nothing) + "  a.csv\n" + std::string(of_abc) +
                      "  b.csv\n");
  folder.put("SHA256SUMS", sums);
  const std::string command = "cd '" + folder.path().string() + "' && sha256sum --strict --status -c SHA256SUMS";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(Digest, AbsentFileAndUnprintableNameFail) {
  const ScratchFolder folder;
  const std::vector<std::string> names{"absent.csv"};
  EXPECT_THROW((void)sha256sums(folder.path(), names), Failure);
  EXPECT_THROW((void)sha256sum_line("a\nb", ""), Failure);
  EXPECT_THROW((void)sha256sum_line("a\\b", ""), Failure);
}

}  // namespace
}  // namespace bezierbench::bundle
