// SPDX-License-Identifier: MIT
#include "experiments/bundle/bundle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/check/verify.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/lock_file.hpp"
#include "experiments/bundle/scratch_folder_test.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Bundle, CreateTakesAbsentEmptyAndBundle) {
  const ScratchFolder folder;
  (void)BundleDirectory::create(folder.path() / "new/deep");
  EXPECT_TRUE(fs::is_directory(folder.path() / "new/deep/blocks"));
  fs::create_directory(folder.path() / "empty");
  const BundleDirectory bundle = BundleDirectory::create(folder.path() / "empty");
  bundle.write("suite.toml", "x");  // a run killed here must find its bundle again
  EXPECT_EQ(BundleDirectory::create(folder.path() / "empty").read("suite.toml"), "x");
  folder.put("old/bundle.json", "{}");
  folder.put("old/accuracy.csv", "x\n");
  EXPECT_TRUE(BundleDirectory::create(folder.path() / "old").has("accuracy.csv"));
  EXPECT_FALSE(fs::exists(folder.path() / "old/blocks"));
}

TEST(Bundle, CreateRefusesWhatIsNotItsOwn) {
  const ScratchFolder folder;
  folder.put("thesis/chapter.tex", "x");
  folder.put("file", "x");
  for (const char* name : {"thesis", "file", "file/below"}) {
    try {
      (void)BundleDirectory::create(folder.path() / name);
      ADD_FAILURE() << name;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.exit(), Exit::input_output);
      EXPECT_THAT(failure.what(), HasSubstr(name));
      EXPECT_THAT(failure.what(), HasSubstr("choose another --out"));
    }
  }
  EXPECT_FALSE(fs::exists(folder.path() / "thesis/blocks"));
  EXPECT_THROW((void)BundleDirectory::open(folder.path() / "thesis"), Failure);
  EXPECT_THROW((void)BundleDirectory::open(folder.path() / "absent"), Failure);
  EXPECT_FALSE(fs::exists(folder.path() / "absent"));
}

TEST(Bundle, WriteTakesPlainNamesOnly) {
  const ScratchFolder folder;
  const BundleDirectory bundle = BundleDirectory::create(folder.path() / "b");
  for (const char* name : {"", ".", "..", "../a", "/a", "a/b", ".hidden", "bundle.json", "SHA256SUMS", "blocks"})
    EXPECT_THROW(bundle.write(name, "x"), std::invalid_argument) << name;
  EXPECT_FALSE(bundle.has("a.csv"));
  EXPECT_FALSE(bundle.has("blocks"));
  bundle.write("a.csv", "x");
  EXPECT_TRUE(bundle.has("a.csv"));
  EXPECT_THROW((void)bundle.read("b.csv"), Failure);
}

TEST(Bundle, FinishedBundleIsWholeForUsAndForCoreutils) {
  const ScratchFolder folder;
  const BundleDirectory bundle = filled(folder.path() / "b");
  folder.put("b/blocks/1.bin", "x");
  folder.put("b/.bezierbench-1-2.tmp", "left by a killed writer");
  finish(bundle, with_state("complete"));
  EXPECT_THAT(verify(bundle.path(), expected), IsEmpty());
  EXPECT_FALSE(fs::exists(bundle.blocks()));
  EXPECT_FALSE(bundle.has(".bezierbench-1-2.tmp"));
  const std::string sums = bundle.read("SHA256SUMS");
  EXPECT_EQ(std::ranges::count(sums, '\n'), 6);
  const std::string command = "cd '" + bundle.path().string() +
                              "' && sha256sum --strict --status -c SHA256SUMS && LC_ALL=C sort -c -k2 SHA256SUMS";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(Bundle, ACompleteOneHasDigestsByMethod) {
  const ScratchFolder folder;
  const BundleDirectory bundle = filled(folder.path() / "b");
  bundle.finish(with_state("partial"));
  EXPECT_FALSE(bundle.has("digests.csv"));
  finish(bundle, with_state("complete"));
  EXPECT_THAT(verify(bundle.path(), expected), IsEmpty());
  EXPECT_EQ(bundle.manifest().accuracy_digest, sha256_hex(bundle.read("digests.csv")));
  EXPECT_THAT(bundle.read("SHA256SUMS"), HasSubstr("  digests.csv\n"));
}

TEST(Bundle, FinishingAgainChangesNothing) {
  const ScratchFolder folder;
  const BundleDirectory bundle = filled(folder.path() / "b");
  finish(bundle, with_state("complete"));
  const auto time = fs::last_write_time(bundle.path() / "bundle.json") - std::chrono::hours(1);
  fs::last_write_time(bundle.path() / "bundle.json", time);
  fs::last_write_time(bundle.path() / "SHA256SUMS", time);
  finish(bundle, with_state("complete"));
  EXPECT_EQ(fs::last_write_time(bundle.path() / "bundle.json"), time);
  EXPECT_EQ(fs::last_write_time(bundle.path() / "SHA256SUMS"), time);
}

TEST(Bundle, ChangeMakesACompleteBundlePartial) {
  const ScratchFolder folder;
  const BundleDirectory bundle = filled(folder.path() / "b");
  finish(bundle, with_state("complete"));
  const std::string table = bundle.read("accuracy.csv");
  bundle.write("accuracy.csv", table.substr(0, table.rfind('\n', table.size() - 2) + 1));
  EXPECT_EQ(bundle.manifest().state, "partial");
  finish(bundle, with_state("complete"));
  EXPECT_THAT(verify(bundle.path(), expected), IsEmpty());
}

TEST(Bundle, PartialKeepsItsBlocks) {
  const ScratchFolder folder;
  const BundleDirectory bundle = filled(folder.path() / "b");
  folder.put("b/blocks/1.bin", "x");
  bundle.finish(with_state("partial"));
  EXPECT_TRUE(fs::exists(bundle.blocks() / "1.bin"));
  EXPECT_THAT(verify(bundle.path(), expected), ElementsAre(HasSubstr("bundle.json: state is partial")));
  EXPECT_THROW(bundle.finish(with_state("done")), Failure);
}

TEST(Bundle, ListedIsWhatNobodyChanged) {
  const ScratchFolder folder;
  const BundleDirectory bundle = filled(folder.path() / "b");
  EXPECT_EQ(bundle.read_if_listed("suite.toml"), std::nullopt);  // no SHA256SUMS yet
  bundle.finish(with_state("partial"));
  EXPECT_EQ(bundle.read_listed("suite.toml"), bundle.read("suite.toml"));
  EXPECT_EQ(bundle.read_if_listed("absent.csv"), std::nullopt);
  EXPECT_EQ(bundle.table("accuracy.csv")->row_count(), parse_csv(bundle.read("accuracy.csv"), "").row_count());
  EXPECT_FALSE(bundle.table("absent.csv"));
  folder.put("b/suite.toml", bundle.read("suite.toml") + "\n");
  EXPECT_EQ(bundle.read_if_listed("suite.toml"), std::nullopt);
  EXPECT_THROW((void)bundle.read_listed("suite.toml"), Failure);
  EXPECT_THROW((void)bundle.read_listed("absent.csv"), Failure);
  fs::remove(bundle.path() / "accuracy.csv");
  EXPECT_THROW((void)bundle.table("accuracy.csv"), Failure);
}

TEST(Bundle, ClearingAwayChangesNoResult) {
  const ScratchFolder folder;
  const BundleDirectory bundle = filled(folder.path() / "b");
  finish(bundle, with_state("complete"));
  folder.put("b/blocks/1.bin", "x");
  folder.put("b/.bezierbench-1-2.tmp", "left by a killed writer");
  folder.put("b/accuracy.csv", "damaged\n");
  const std::string sums = bundle.read("SHA256SUMS");
  bundle.clear_away();
  EXPECT_FALSE(fs::exists(bundle.blocks()));
  EXPECT_FALSE(bundle.has(".bezierbench-1-2.tmp"));
  EXPECT_EQ(bundle.read("SHA256SUMS"), sums);
  EXPECT_EQ(bundle.manifest().state, "complete");
}

// A shard that begins puts its locks into blocks/ while another shard, which has just completed the bundle, removes the
// folder.
TEST(Bundle, LocksMayComeWhileBlocksAreRemoved) {
  const ScratchFolder folder;
  const BundleDirectory bundle = filled(folder.path() / "b");
  std::atomic<bool> done{false};
  std::vector<std::thread> shards;
  for (int shard = 0; shard < 2; ++shard) {
    shards.emplace_back([&, shard] {
      while (!done) {
        try {
          const LockFile run(bundle.blocks() / "run.lock");
          const LockFile own(bundle.blocks() / ("shard-" + std::to_string(shard) + ".lock"));
          if (shard == 1) bundle.clear_away();
        } catch (const Failure& failure) {
          ADD_FAILURE() << failure.what();
        }
      }
    });
  }
  for (int round = 0; round < 1000; ++round) EXPECT_NO_THROW(bundle.clear_away());
  done = true;
  for (auto& shard : shards) shard.join();
}

TEST(Bundle, LocksAreRegularFiles) {
  const ScratchFolder folder;
  fs::create_symlink("away", folder.path() / "link");
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "pipe"}) EXPECT_THROW(LockFile(folder.path() / name), Failure) << name;
  EXPECT_FALSE(fs::exists(folder.path() / "away"));
}

// Where SHA256SUMS cannot be written, the old `complete` must not remain, nor a new one appear.
TEST(Bundle, FailingFinishNeverLeavesComplete) {
  const ScratchFolder folder;
  const BundleDirectory bundle = filled(folder.path() / "b");
  finish(bundle, with_state("complete"));
  std::string changed = bundle.read("accuracy.csv");
  changed.replace(changed.find(",100,"), 5, ",101,");
  folder.put("b/accuracy.csv", changed);
  fs::remove(bundle.path() / "SHA256SUMS");
  fs::create_directory(bundle.path() / "SHA256SUMS");
  EXPECT_THROW(finish(bundle, with_state("complete")), Failure);
  EXPECT_EQ(bundle.manifest().state, "partial");
}

}  // namespace
}  // namespace bezierbench::bundle
