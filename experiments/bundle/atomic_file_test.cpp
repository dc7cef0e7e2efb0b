// SPDX-License-Identifier: MIT
#include "experiments/bundle/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "experiments/bundle/scratch_folder_test.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// The message of the Failure that `call` throws.
template <typename Call>
std::string line_of(Call call) {
  try {
    call();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::input_output);
    EXPECT_THAT(failure.what(), Not(HasSubstr("\n")));
    return failure.what();
  }
  ADD_FAILURE() << "no failure";
  return {};
}

TEST(AtomicFile, WritesReplacesAndReadsAllBytes) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "accuracy.csv";
  std::string bytes(300'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 7 % 256);
  write_file(path, "old and longer than nothing");
  write_file(path, bytes);
  EXPECT_EQ(read_file(path), bytes);
  write_file(path, "");
  EXPECT_EQ(read_file(path), "");
  EXPECT_EQ(folder.names(), std::set<std::string>{"accuracy.csv"});
}

TEST(AtomicFile, NewFileGetsTheUsersUsualMode) {
  const ScratchFolder folder;
  const mode_t before = umask(022);
  write_file(folder.path() / "a", "x");
  umask(before);
  EXPECT_EQ(fs::status(folder.path() / "a").permissions(), fs::perms(0644));
}

TEST(AtomicFile, ReplacementIsANewFileSoThatAnOpenReaderKeepsTheOldOne) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "a";
  write_file(path, "old");
  std::ifstream reader(path);
  write_file(path, "new");
  std::string word;
  reader >> word;
  EXPECT_EQ(word, "old");
}

TEST(AtomicFile, FullDeviceIsReportedInOneLine) {
  EXPECT_EQ(line_of([] { write_file("/dev/full", "x"); }),
            "/dev/full: cannot be written: No space left on device; free space or choose another --out");
  EXPECT_EQ(line_of([] { write_file("/dev/full", "x", "--knots-out"); }),
            "/dev/full: cannot be written: No space left on device; free space or choose another --knots-out");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(AtomicFile, FollowsASymbolicLink) {
  const ScratchFolder folder;
  fs::create_directory(folder.path() / "far");
  write_file(folder.path() / "far/a", "old");
  fs::create_symlink("far/a", folder.path() / "link");
  write_file(folder.path() / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(read_file(folder.path() / "far/a"), "new");
}

TEST(AtomicFile, UnwritableFolderIsReported) {
  const ScratchFolder folder;
  write_file(folder.path() / "file", "kept");
  EXPECT_THAT(line_of([&] { write_file(folder.path() / "file/a.csv", "x"); }),
              AllOf(StartsWith((folder.path() / "file/a.csv").string() + ": cannot be written: "),
                    HasSubstr("Not a directory"), HasSubstr("--out")));
  EXPECT_THAT(line_of([&] { write_file(folder.path() / "absent/a.csv", "x"); }), HasSubstr("No such file"));
  EXPECT_THAT(line_of([&] { write_file(folder.path(), "x"); }), HasSubstr("Is a directory"));
  EXPECT_EQ(read_file(folder.path() / "file"), "kept");
  EXPECT_EQ(folder.names(), std::set<std::string>{"file"});
}

TEST(AtomicFile, ThreadsDoNotShareTemporaryFiles) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "a";
  std::vector<std::thread> threads;
  for (char letter : {'a', 'b', 'c', 'd'}) {
    threads.emplace_back([&path, letter] {
      for (int i = 0; i < 20; ++i) write_file(path, std::string(50'000, letter));
    });
  }
  for (std::thread& thread : threads) thread.join();
  const std::string bytes = read_file(path);
  EXPECT_EQ(bytes, std::string(50'000, bytes.at(0)));
  EXPECT_EQ(folder.names(), std::set<std::string>{"a"});
}

TEST(AtomicFile, UnreadableIsReported) {
  const ScratchFolder folder;
  EXPECT_EQ(line_of([&] { (void)read_file(folder.path() / "absent"); }),
            (folder.path() / "absent").string() +
                ": cannot be read: No such file or directory; check the path and its permissions");
  EXPECT_THAT(line_of([&] { (void)read_file(folder.path()); }), HasSubstr("Is a directory"));
}

TEST(BundleFile, OnlyRegularFilesAreRead) {
  const ScratchFolder folder;
  folder.put("file", "x");
  fs::create_symlink("file", folder.path() / "link");
  fs::create_symlink("/dev/zero", folder.path() / "endless");
  fs::create_directory(folder.path() / "folder");
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);  // nobody writes to it
  EXPECT_EQ(read_bundle_file(folder.path() / "file"), "x");
  for (const fs::path& path : {folder.path() / "link", folder.path() / "endless", folder.path() / "pipe",
                               folder.path() / "folder", fs::path("/dev/zero")})
    EXPECT_THAT(line_of([&] { (void)read_bundle_file(path); }),
                testing::AllOf(HasSubstr(path.string()), HasSubstr("is not a regular file")));
}

TEST(BundleFile, WhatIsThereIsReplacedAndNotWrittenThrough) {
  const ScratchFolder folder;
  folder.put("far/away", "kept");
  fs::create_symlink("far/away", folder.path() / "link");
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "pipe", "new"}) {
    write_bundle_file(folder.path() / name, "ours");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder.path() / name))) << name;
    EXPECT_EQ(read_bundle_file(folder.path() / name), "ours");
  }
  EXPECT_EQ(read_file(folder.path() / "far/away"), "kept");
}

}  // namespace
}  // namespace bezierbench::bundle
