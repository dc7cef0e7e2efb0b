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
constexpr double long_enough = 0.01 * second;  // for one sample, beside the errors of clocks and first calls
constexpr double enough = 0.4 * second;        // for all samples of a study
/// With so many trials lane kernels judge whole groups, and errors show their usual spread.
constexpr std::int64_t enough_to_stand_for_all = 64;
/// The bins of a histogram over ten binades, 128 in each. With more trials than bins, another trial rarely fills one.
constexpr double bins_of_usual_errors = 1280;
constexpr std::size_t least_samples = 2;
constexpr std::size_t most_samples = 16;

/// Nanoseconds of this thread. Other threads and processes do not count.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * second + static_cast<double>(now.tv_nsec);
}

double allocated_bytes() {
  const auto heap = mallinfo2();
  return static_cast<double>(heap.uordblks) + static_cast<double>(heap.hblkhd);
}

/// The job of the same study with fewer trials and replicates. Work on some of the trials only is cut in proportion:
/// audited and decomposed trials are all of the first replicate, and a pilot has no other.
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

/// The measurements of one part of a pilot.
struct Sample {
  double nanoseconds = 0;
  double cost = 0;
  double bytes = 0;   ///< of its result, saved
  double memory = 0;  ///< of its result
};

/// Runs the first `blocks` blocks of a part, or fewer where these take `enough` time. The blocks of a kind without
/// trials cannot be made shorter.
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

/// The part at which the summed cost of the parts exceeds this share of the total. Where shares are spread evenly, the
/// parts are chosen in proportion to their cost.
std::size_t part_at(const Job& job, double share) {
  double left = 0;
  for (std::size_t part = 0; part < job.parts(); ++part) left += job.cost(part);
  left *= share;
  std::size_t part = 0;
  for (; part + 1 < job.parts() && left >= job.cost(part); ++part) left -= job.cost(part);
  return part;
}

/// Element `number`, from 1, of van der Corput's sequence 1/2, 1/4, 3/4, 1/8, 5/8, ... (1935). Its first elements,
/// however many, are spread over the unit interval.
double spread(unsigned number) {
  double share = 0;
  for (double digit = 0.5; number > 0; number /= 2, digit /= 2) share += digit * (number % 2);
  return share;
}

/// The time and the size of the result of a part with so many trials in so many blocks.
struct Duration {
  double trials = 0;
  double blocks = 0;
  double nanoseconds = 0;
  double bytes = 0;
};

/// The time per trial where there are `blocks_per_trial` blocks for each, divided by the time per trial in `last`. A
/// block has work of its own besides its trials, such as the comparison of lane kernels with the methods' own kernels.
/// Two durations with different numbers of trials per block determine both.
double share_of_blocks(const Duration& before, const Duration& last, double blocks_per_trial) {
  const double determinant = before.blocks * last.trials - last.blocks * before.trials;
  if (determinant <= 0) return 1;  // both have equally many blocks per trial
  const double block = (before.nanoseconds * last.trials - last.nanoseconds * before.trials) / determinant;
  if (!(block > 0)) return 1;
  const double trial = std::max(0.0, last.nanoseconds - block * last.blocks) / last.trials;
  return (block * blocks_per_trial + trial) * last.trials / last.nanoseconds;
}

/// The study with a few trials: enough of them to be timed and to stand for all, fewer where these take too long or the
/// study has no more.
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
      if (trials_ == 1 && sample.nanoseconds < long_enough) sample = first_sample();  // now warmed up
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
  /// The time of a trial of the study divided by that of a trial of this pilot.
  [[nodiscard]] double factor() const { return factor_; }
  /// Near the pilot's number of trials, the bytes of a result grow with this power of the number. Only the filled bins
  /// of a histogram take bytes, and the more of them are filled, the more rarely a trial fills another.
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

  /// Samples whose results are of interest: of parts at equal distances, whatever they cost.
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

/// The memory of a result after `trials` trials over that after `before` trials, which must be enough to show the usual
/// spread of errors. A histogram has all binades from the smallest error to the largest. Usual errors lie in ten
/// binades, and the smallest of k errors is about 1/k of a usual one, which adds log2 k binades.
double growth(std::int64_t before, double trials) {
  constexpr double binades = 10;
  return (binades + std::log2(trials)) / (binades + std::log2(static_cast<double>(before)));
}

/// The factors by which results grow from the few trials of a pilot to `trials` trials.
struct Broadening {
  std::int64_t trials = 1;
  double bytes = 1;
  double memory = 1;
};

/// Measures them at the part that costs least, with as many trials as show the usual spread of errors, or as many as
/// there is time for.
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

/// What each replicate adds to the result of a part: the difference between `many` replicates of one trial and twice as
/// many.
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
  if (pilot.job().exclusive()) {  // the results are of one block each
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
