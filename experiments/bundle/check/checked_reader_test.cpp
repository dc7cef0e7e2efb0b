// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/checked_reader.hpp"

#include <gtest/gtest.h>

#include "experiments/bundle/scratch_folder_test.hpp"
#include "experiments/bundle/small_bundle_test.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;

class Reader : public testing::Test {
 protected:
  Reader() : bundle_(filled(folder_.path() / "b")) { finish(bundle_, with_state("complete")); }

  [[nodiscard]] CheckedReader reader() const { return CheckedReader(bundle_.path()); }

  ScratchFolder folder_;
  BundleDirectory bundle_;
};

TEST_F(Reader, GivesWhatIsListed) {
  const auto reader = this->reader();
  EXPECT_EQ(reader.read("accuracy.csv"), committed("accuracy.csv"));
  EXPECT_EQ(reader.manifest().seed, 1U);
  EXPECT_FALSE(reader.has("conversion.csv"));
}

TEST_F(Reader, RefusesWhatIsNot) {
  folder_.put("b/accuracy.csv", "changed");
  folder_.put("b/search.csv", "added");
  fs::remove(bundle_.path() / "timing.csv");
  const auto reader = this->reader();
  EXPECT_THROW((void)reader.read("accuracy.csv"), Failure);
  EXPECT_THROW((void)reader.read("search.csv"), Failure);
  EXPECT_THROW((void)reader.has("timing.csv"), Failure);
}

TEST_F(Reader, WantsAWholeList) {
  folder_.put("b/SHA256SUMS", "nonsense\n");
  EXPECT_THROW((void)reader(), Failure);
  fs::remove(bundle_.path() / "SHA256SUMS");
  EXPECT_THROW((void)reader(), Failure);
}

}  // namespace
}  // namespace bezierbench::bundle
