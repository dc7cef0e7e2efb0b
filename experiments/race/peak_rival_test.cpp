// SPDX-License-Identifier: MIT
#include "experiments/race/peak_rival.hpp"

#include <gtest/gtest.h>

namespace bezierbench::race {
namespace {

TEST(PeakRival, ChecksThatTheWorkWasDone) {
  for (const auto* target : batch::usable_targets())
    for (const auto& work : {batch::works_of<double>(*target).back().multiply_add(),
                             batch::works_of<double>(*target).back().multiply_add_and_add}) {
      const Rival rival = peak_rival(work);
      EXPECT_EQ(static_cast<double>(rival.points_per_batch), work.flops);
      EXPECT_FALSE(rival.check()) << "nothing ran yet";
      rival.run();
      EXPECT_TRUE(rival.check());
      EXPECT_FALSE(rival.check()) << "a check uses the work up";
    }
}

TEST(PeakRival, CatchesAChainThatIsLeftOut) {
  const batch::OperationWork<double> lazy{[](double, double* values) { values[0] = 1; }, 0.5, {{{2, 0, 1}, {}}}, 2, 4};
  const Rival rival = peak_rival(lazy);
  rival.run();
  EXPECT_FALSE(rival.check());
}

}  // namespace
}  // namespace bezierbench::race
