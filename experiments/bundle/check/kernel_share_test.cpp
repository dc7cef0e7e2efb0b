// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/kernel_share.hpp"

#include <gtest/gtest.h>

#include <string>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/scratch_folder_test.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

/// The kernel share of a bundle with this reference.csv.
std::optional<KernelShare> share_of(const std::string& table) {
  const ScratchFolder folder;
  BundleDirectory::create(folder.path() / "b").write("reference.csv", table);
  return kernel_share(folder.path() / "b");
}

TEST(KernelShare, IsTheSumOverCellsAndMethods) {
  const auto share = share_of("study,method,trials,own_kernel\ns,a,2000,2\ns,b,2000,2000\ns2,a,10,1\n");
  ASSERT_TRUE(share);
  EXPECT_EQ(share->judged, 4010U);
  EXPECT_EQ(share->own, 2003U);
}

TEST(KernelShare, IsUnknownOfOlderBundlesAndOthers) {
  EXPECT_FALSE(share_of("study,trials\ns,2000\n"));
  const ScratchFolder folder;
  (void)BundleDirectory::create(folder.path() / "b");
  EXPECT_FALSE(kernel_share(folder.path() / "b"));
}

TEST(KernelShare, NamesAFieldThatIsNoCount) {
  EXPECT_THROW((void)share_of("trials,own_kernel\n2000,many\n"), Failure);
  EXPECT_THROW((void)share_of("trials,own_kernel\n-1,1\n"), Failure);
}

}  // namespace
}  // namespace bezierbench::bundle
