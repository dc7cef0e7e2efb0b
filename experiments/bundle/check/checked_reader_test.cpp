// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/checked_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/bundle/scratch_folder_test.hpp"
#include "experiments/bundle/small_bundle_test.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;

class Reader : public testing::Test {
 protected:
  Reader() : bundle_(filled(folder_.path() / "b")) { finish(bundle_, with_state("complete")); }

  [[nodiscard]] CheckedReader reader(Damage damage) const { return {bundle_.path(), damage}; }

  ScratchFolder folder_;
  BundleDirectory bundle_;
};

TEST_F(Reader, GivesWhatIsListed) {
  auto reader = this->reader(Damage::refused);
  EXPECT_EQ(reader.read("accuracy.csv"), committed("accuracy.csv"));
  EXPECT_EQ(reader.manifest().seed, 1U);
  EXPECT_FALSE(reader.has("conversion.csv"));
  EXPECT_THAT(reader.told(), IsEmpty());
}

TEST_F(Reader, RefusesOrTellsWhatIsNot) {
  folder_.put("b/accuracy.csv", "changed");
  folder_.put("b/search.csv", "added");
  fs::remove(bundle_.path() / "timing.csv");
  auto strict = reader(Damage::refused);
  EXPECT_THROW((void)strict.read("accuracy.csv"), Failure);
  EXPECT_THROW((void)strict.read("search.csv"), Failure);
  EXPECT_THROW((void)strict.has("timing.csv"), Failure);
  auto lenient = reader(Damage::told);
  EXPECT_EQ(lenient.read("accuracy.csv"), "changed");
  EXPECT_EQ(lenient.read("accuracy.csv"), "changed");
  EXPECT_EQ(lenient.read("search.csv"), "added");
  EXPECT_FALSE(lenient.has("timing.csv"));
  EXPECT_THAT(lenient.told(),
              ElementsAre(EndsWith("b/accuracy.csv"), EndsWith("b/search.csv"), EndsWith("b/timing.csv")));
}

TEST_F(Reader, WantsAWholeList) {
  folder_.put("b/SHA256SUMS", "nonsense\n");
  EXPECT_THROW((void)reader(Damage::refused), Failure);
  fs::remove(bundle_.path() / "SHA256SUMS");
  EXPECT_THROW((void)reader(Damage::refused), Failure);
  EXPECT_THAT(reader(Damage::told).told(), ElementsAre(EndsWith("b/SHA256SUMS")));
}

}  // namespace
}  // namespace bezierbench::bundle
