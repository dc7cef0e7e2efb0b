// SPDX-License-Identifier: MIT
#include "experiments/run/estimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <memory>

namespace bezierbench::run {
namespace {

constexpr double second = 1e9;  // in nanoseconds
constexpr double trial_nanoseconds = 1e3;
constexpr double audit_nanoseconds = 20e3;

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * second + static_cast<double>(now.tv_nsec);
}

struct Nothing {
  template <class Bytes, class Self>
  static void each_field(Bytes& /*bytes*/, Self& /*self*/) {}
  void merge(const Nothing& /*other*/) {}
};

/// A job that computes for a fixed time per trial. A block is one replicate. The audited trials, which the first
/// replicate has, take longer.
class Busy final : public JobOf<Nothing> {
 public:
  Busy(const suite::Study& study, const JobContext& context)
      : trials_(study.trials), replicates_(study.replicates), audited_(context.audited_trials) {}
  [[nodiscard]] std::size_t parts() const override { return 1; }
  [[nodiscard]] std::size_t blocks_per_part() const override { return static_cast<std::size_t>(replicates_); }
  [[nodiscard]] double cost(std::size_t /*part*/) const override { return static_cast<double>(trials_); }
  [[nodiscard]] Extent extent() const override { return {}; }
  void write(tables::Tables& /*tables*/) const override {}
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }

  [[nodiscard]] double nanoseconds(std::size_t block) const {
    return trial_nanoseconds * static_cast<double>(trials_) +
           (block == 0 ? audit_nanoseconds * static_cast<double>(std::min(audited_, trials_)) : 0);
  }

 protected:
  [[nodiscard]] Nothing work(std::size_t block) const override {
    for (const double end = processor_time() + nanoseconds(block); processor_time() < end;) {
    }
    return {};
  }

 private:
  std::int64_t trials_;
  std::int64_t replicates_;
  std::int64_t audited_;
};

std::unique_ptr<Job> busy_job(const suite::Study& study, const JobContext& context) {
  return std::make_unique<Busy>(study, context);
}

// Some hundred trials of the first replicate stand for all, most of which are not audited.
TEST(Estimate, WhatOnlyTheFirstTrialsTakeIsNotTakenForAll) {
  suite::Study study;
  study.trials = 1000;
  study.replicates = 400;
  const Busy whole(study, {});
  double really = 0;
  for (std::size_t block = 0; block < whole.blocks(); ++block) really += whole.nanoseconds(block);
  const double estimated = estimate(study, {.make_job = busy_job}, {}).per_cost * whole.total_cost();
  EXPECT_GT(estimated / really, 0.5);
  EXPECT_LT(estimated / really, 2);
}

}  // namespace
}  // namespace bezierbench::run
