// SPDX-License-Identifier: MIT
#include "experiments/run/estimate.hpp"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <vector>

#include "experiments/number/bytes.hpp"
#include "experiments/run/interruption.hpp"

namespace bezierbench::run {
namespace {

constexpr double second = 1e9;                 // in nanoseconds
constexpr double long_enough = 0.01 * second;  // of one sample: clocks and first calls do not show in it
constexpr double enough = 0.4 * second;        // of all samples of a study
/// Trials that are judged together by lane kernels, and show how widely errors are spread.
constexpr std::int64_t enough_to_stand_for_all = 64;
/// Of a histogram with 128 bins for each of ten binades. More trials than bins hardly take another bin.
constexpr double bins_of_usual_errors = 1280;
constexpr std::size_t least_samples = 2;
constexpr std::size_t most_samples = 16;

/// Of this thread: what others do on the machine does not count.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * second + static_cast<double>(now.tv_nsec);
}

double allocated_bytes() {
  const auto heap = mallinfo2();
  return static_cast<double>(heap.uordblks) + static_cast<double>(heap.hblkhd);
}

/// The job of the same study with so many trials and replicates, and whatever is done to some of the trials only cut in
/// proportion: of the trials that are audited and decomposed, all are of the first replicate, and so is a pilot.
std::unique_ptr<Job> cut_job(suite::Study study, const Kinds& kinds, JobContext context, std::int64_t trials,
                             std::int64_t replicates) {
  trials = std::min(trials, study.trials);
  replicates = std::min(replicates, study.replicates);
  const double part = static_cast<double>(trials) / static_cast<double>(study.trials) *
                      static_cast<double>(replicates) / static_cast<double>(study.replicates);
  const auto in_proportion = [&](std::int64_t count) { return part * static_cast<double>(count); };
  const auto at_least_one = [&](std::int64_t count) {
    return static_cast<std::int64_t>(std::ceil(in_proportion(count)));
  };
  if (auto* keys = std::get_if<suite::AccuracyKeys>(&study.keys))
    keys->decomposed_trials = at_least_one(keys->decomposed_trials);
  if (auto* keys = std::get_if<suite::SearchKeys>(&study.keys)) keys->budget = at_least_one(keys->budget);
  context.audited_trials = std::llround(in_proportion(context.audited_trials));
  study.trials = trials;
  study.replicates = replicates;
  return kinds.make_job(study, context);
}

/// What one part of a pilot took.
struct Sample {
  double nanoseconds = 0;
  double cost = 0;
  double bytes = 0;   ///< of its result, saved
  double memory = 0;  ///< of its result
};

/// The first blocks of a part: `blocks`, or as many as time is enough for. A kind without trials cannot be cut.
Sample sample_of(const Job& job, std::size_t part, std::size_t blocks) {
  const double memory = allocated_bytes();
  const double begin = processor_time();
  double taken = 0;
  std::unique_ptr<Result> result;
  std::size_t done = 0;
  for (; done < blocks && taken < enough && !interrupted(); ++done) {
    auto block = job.run_block(part * job.blocks_per_part() + done);
    if (result)
      result->merge(*block);
    else
      result = std::move(block);
    taken = processor_time() - begin;
  }
  Sample sample{.nanoseconds = taken, .cost = job.cost(part) * static_cast<double>(done)};
  if (!result) return sample;
  sample.memory = std::max(0.0, allocated_bytes() - memory);
  number::ByteWriter bytes;
  result->save(bytes);
  sample.bytes = static_cast<double>(bytes.bytes().size());
  return sample;
}

/// The part that has this share of the cost of all before it: one that costs more is more likely to be chosen.
std::size_t part_at(const Job& job, double share) {
  double left = 0;
  for (std::size_t part = 0; part < job.parts(); ++part) left += job.cost(part);
  left *= share;
  std::size_t part = 0;
  for (; part + 1 < job.parts() && left >= job.cost(part); ++part) left -= job.cost(part);
  return part;
}

/// 1/2, 1/4, 3/4, 1/8, 5/8, ...: wherever the sequence ends, its beginning is spread over the unit interval (van der
/// Corput 1935).
double spread(unsigned number) {
  double share = 0;
  for (double digit = 0.5; number > 0; number /= 2, digit /= 2) share += digit * (number % 2);
  return share;
}

/// How long a part took that has so many trials in so many blocks, and what it gave.
struct Duration {
  double trials = 0;
  double blocks = 0;
  double nanoseconds = 0;
  double bytes = 0;
};

/// What a trial takes where `blocks_per_trial` are made of them, over what one took in `last`. Every block has work of
/// its own besides that of its trials, such as the comparison of lane kernels with the methods' own: two durations tell
/// them apart.
double share_of_blocks(const Duration& before, const Duration& last, double blocks_per_trial) {
  const double determinant = before.blocks * last.trials - last.blocks * before.trials;
  if (determinant <= 0) return 1;  // as many blocks for a trial in both
  const double block = (before.nanoseconds * last.trials - last.nanoseconds * before.trials) / determinant;
  if (!(block > 0)) return 1;
  const double trial = std::max(0.0, last.nanoseconds - block * last.blocks) / last.trials;
  return (block * blocks_per_trial + trial) * last.trials / last.nanoseconds;
}

/// A pilot of as many trials as can be timed, and as stand for all; of fewer where these take too long, or the study
/// has no more.
class Pilot {
 public:
  Pilot(const suite::Study& study, const Kinds& kinds, const JobContext& context) : trials_(study.trials) {
    job_ = kinds.make_job(study, context);
    if (job_->exclusive()) return;
    const double blocks_per_trial = static_cast<double>(job_->blocks_per_part()) / static_cast<double>(study.trials) /
                                    static_cast<double>(study.replicates);
    Duration before;
    for (trials_ = 1;; trials_ *= 4) {
      job_ = cut_job(study, kinds, context, trials_, 1);
      if (job_->parts() == 0 || interrupted()) return;
      auto sample = first_sample();
      if (trials_ == 1 && sample.nanoseconds < long_enough) sample = first_sample();  // without what is done only once
      const Duration now{.trials = static_cast<double>(trials_),
                         .blocks = static_cast<double>(job_->blocks_per_part()),
                         .nanoseconds = sample.nanoseconds,
                         .bytes = sample.bytes};
      if (trials_ > 1) factor_ = share_of_blocks(before, now, blocks_per_trial);
      if (before.bytes > 0) exponent_ = std::clamp(std::log(now.bytes / before.bytes) / std::log(4.0), 0.0, 1.0);
      if (trials_ > study.trials / 4 || 4 * now.nanoseconds >= enough) return;
      if (now.nanoseconds >= long_enough && trials_ >= enough_to_stand_for_all) return;
      before = now;
    }
  }

  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] std::int64_t trials() const { return trials_; }
  /// What a trial of the study takes over what one of this pilot takes.
  [[nodiscard]] double factor() const { return factor_; }
  /// How results grow as bytes: by this power of the number of trials, where that is the pilot's. Of a histogram the
  /// bins count in which anything is; the more of them are taken, the more rarely a trial takes another.
  [[nodiscard]] double exponent() const { return exponent_; }

  [[nodiscard]] std::vector<Sample> samples() const {
    std::vector<Sample> all;
    if (job_->parts() == 0) return all;
    for (double taken = 0; all.size() < least_samples || (all.size() < most_samples && taken < enough);) {
      if (interrupted()) break;
      const auto part = part_at(*job_, spread(static_cast<unsigned>(all.size()) + 1));
      all.push_back(sample_of(*job_, part, job_->exclusive() ? 1 : job_->blocks_per_part()));
      taken += all.back().nanoseconds;
    }
    return all;
  }

  /// Of parts at equal distances, whatever they cost: what their results are.
  [[nodiscard]] std::vector<Sample> results() const {
    std::vector<Sample> all;
    double taken = 0;
    for (unsigned k = 1; k <= most_samples && (k <= least_samples || taken < enough) && !interrupted(); ++k) {
      if (job_->parts() == 0) break;
      const auto part = static_cast<std::size_t>(spread(k) * static_cast<double>(job_->parts()));
      all.push_back(sample_of(*job_, part, job_->exclusive() ? 1 : job_->blocks_per_part()));
      taken += all.back().nanoseconds;
    }
    return all;
  }

 private:
  [[nodiscard]] Sample first_sample() const { return sample_of(*job_, part_at(*job_, 0.5), job_->blocks_per_part()); }

  std::int64_t trials_;
  double factor_ = 1;
  double exponent_ = 0;
  std::unique_ptr<Job> job_;
};

/// How much larger a result is after `trials` trials than after `before`, if those were enough to show how widely
/// errors are spread: the least of k is about a k-th of the usual one, so that a histogram has some log2 k binades more
/// than the ten of the errors themselves.
double growth(std::int64_t before, double trials) {
  constexpr double binades = 10;
  return (binades + std::log2(trials)) / (binades + std::log2(static_cast<double>(before)));
}

/// What results grow by, from the few trials of a pilot to so many.
struct Broadening {
  std::int64_t trials = 1;
  double bytes = 1;
  double memory = 1;
};

/// To as many as show how widely errors are spread, or as many as there is time for: by the part that costs least.
Broadening broadening(const suite::Study& study, const Kinds& kinds, const JobContext& context, std::int64_t few) {
  const auto of = [&](std::int64_t trials) {
    const auto job = cut_job(study, kinds, context, trials, 1);
    std::size_t cheapest = 0;
    for (std::size_t part = 1; part < job->parts(); ++part)
      if (job->cost(part) < job->cost(cheapest)) cheapest = part;
    return job->parts() == 0 ? Sample{} : sample_of(*job, cheapest, job->blocks_per_part());
  };
  const auto most = std::min(enough_to_stand_for_all, study.trials);
  if (few >= most) return {.trials = few};
  const Sample before = of(few);
  const double affordable = static_cast<double>(few) * std::max(1.0, enough / std::max(1.0, before.nanoseconds));
  const auto many = static_cast<std::int64_t>(std::min(static_cast<double>(most), affordable));
  const Sample after = of(many);
  const auto ratio = [](double a, double b) { return a > 0 ? std::max(1.0, b / a) : 1; };
  return {many, ratio(before.bytes, after.bytes), ratio(before.memory, after.memory)};
}

/// What each replicate adds to what is kept of a part: few trials are made of many of them, and of twice as many.
Sample per_replicate(const suite::Study& study, const Kinds& kinds, const JobContext& context) {
  constexpr std::int64_t many = 64;
  if (study.replicates < 2 * many) return {};
  const auto of = [&](std::int64_t replicates) {
    const auto job = cut_job(study, kinds, context, 1, replicates);
    return job->parts() == 0 ? Sample{} : sample_of(*job, part_at(*job, 0.5), job->blocks_per_part());
  };
  const Sample few = of(many);
  const Sample more = of(2 * many);
  const auto slope = [](double a, double b) { return std::max(0.0, b - a) / static_cast<double>(many); };
  return {.bytes = slope(few.bytes, more.bytes), .memory = slope(few.memory, more.memory)};
}

}  // namespace

StudyEstimate estimate(const suite::Study& study, const Kinds& kinds, const JobContext& context) {
  const Pilot pilot(study, kinds, context);
  const auto samples = pilot.samples();
  StudyEstimate sum;
  double bytes = 0;
  double memory = 0;
  for (const auto& one : samples)
    sum.per_cost += pilot.factor() * one.nanoseconds / one.cost / static_cast<double>(samples.size());
  const auto results = pilot.results();
  for (const auto& one : results) {
    bytes += one.bytes / static_cast<double>(results.size());
    memory += one.memory / static_cast<double>(results.size());
  }
  const auto parts = static_cast<double>(pilot.job().parts());
  const auto replicates = static_cast<double>(study.replicates);
  if (pilot.job().exclusive()) {  // of one block
    const auto blocks = static_cast<double>(pilot.job().blocks());
    return {.per_cost = sum.per_cost,
            .result_bytes = bytes * blocks,
            .result_memory = memory * blocks,
            .result_exponent = 1};
  }
  const auto broader = broadening(study, kinds, context, pilot.trials());
  const auto each = per_replicate(study, kinds, context);
  const double trials = static_cast<double>(study.trials) * replicates;
  const double filled = std::max(static_cast<double>(broader.trials), bins_of_usual_errors);
  const double fuller = std::pow(std::min(trials, filled) / static_cast<double>(broader.trials), pilot.exponent());
  sum.result_exponent = trials < bins_of_usual_errors ? pilot.exponent() : 0;
  const double larger = growth(broader.trials, trials);
  sum.result_bytes = parts * (bytes * broader.bytes * fuller + each.bytes * replicates);
  sum.result_memory = parts * (memory * broader.memory * larger + each.memory * replicates);
  return sum;
}

}  // namespace bezierbench::run
