// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/checkpoints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <memory>

#include "experiments/bundle/scratch_folder_test.hpp"

namespace bezierbench::run {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t result_numbers = 2500;

/// As many bytes after any number of blocks.
struct Full {
  std::array<double, result_numbers> numbers{};

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.numbers);
  }
  void merge(const Full& /*other*/) {}
};

class FullJob final : public JobOf<Full> {
 public:
  FullJob(std::size_t parts, std::size_t each) : parts_(parts), each_(each) {}
  [[nodiscard]] std::size_t parts() const override { return parts_; }
  [[nodiscard]] std::size_t blocks_per_part() const override { return each_; }
  [[nodiscard]] double cost(std::size_t /*part*/) const override { return 1; }
  [[nodiscard]] Extent extent() const override { return {}; }
  void write(tables::Tables& /*tables*/) const override {}
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }

 protected:
  [[nodiscard]] Full work(std::size_t /*block*/) const override { return {}; }

 private:
  std::size_t parts_;
  std::size_t each_;
};

struct Contents {
  std::size_t files = 0;
  double bytes = 0;
};

Contents contents(const fs::path& folder) {
  Contents sum;
  for (const auto& entry : fs::directory_iterator(folder)) {
    ++sum.files;
    sum.bytes += static_cast<double>(entry.file_size());
  }
  return sum;
}

struct Division {
  std::size_t parts;
  std::size_t blocks_per_part;
};

class DiskOfBlocks : public testing::TestWithParam<Division> {};

// A file for each block: before the first gathering, after some, of whole parts and of pieces of them.
INSTANTIATE_TEST_SUITE_P(Checkpoints, DiskOfBlocks,
                         testing::Values(Division{20, 1}, Division{5, 8}, Division{64, 1}, Division{70, 1},
                                         Division{200, 1}, Division{4, 50}, Division{1, 130}));

TEST_P(DiskOfBlocks, IsAsEstimated) {
  const bundle::ScratchFolder folder;
  Jobs jobs;
  jobs.push_back(std::make_unique<FullJob>(GetParam().parts, GetParam().blocks_per_part));
  const Job& job = *jobs[0];
  Checkpoints checkpoints(jobs, {folder.path(), "whole", {}, "exact", "this", std::chrono::milliseconds(0)});
  double most = 0;
  Contents before;
  for (std::size_t block = 0; block < job.blocks(); ++block) {
    checkpoints.add(0, block, job.run_block(block));
    const Contents now = contents(folder.path());
    const bool gathered = now.files < before.files;  // what is there was written beside what it replaced
    most = std::max(most, gathered ? before.bytes + now.bytes : now.bytes);
    before = now;
  }
  const double merged = static_cast<double>(job.parts() * result_numbers * sizeof(double));
  const double estimated =
      merged * Checkpoints::most_on_disk(static_cast<double>(job.blocks()), static_cast<double>(job.blocks_per_part()));
  EXPECT_NEAR(most / estimated, 1, 0.1);
}

}  // namespace
}  // namespace bezierbench::run
