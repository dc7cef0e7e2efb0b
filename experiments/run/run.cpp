// SPDX-License-Identifier: MIT
#include "experiments/run/run.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <cstdio>
#include <system_error>
#include <vector>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/check/verify.hpp"
#include "experiments/bundle/folder.hpp"
#include "experiments/echo.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/blocks/block_order.hpp"
#include "experiments/run/blocks/parallel_ranges.hpp"
#include "experiments/run/expected.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/run/notes.hpp"
#include "experiments/run/plan.hpp"
#include "experiments/run/progress.hpp"
#include "experiments/run/progress_text.hpp"
#include "experiments/run/run_folder.hpp"

namespace bezierbench::run {
namespace {

std::string name_of(const std::optional<Shard>& shard) {
  return shard ? fmt::format("shard {}/{}", shard->number, shard->count) : "run";
}

/// The work of this process.
class Share {
 public:
  Share(const Jobs& jobs, const Checkpoints& checkpoints, const Shard& shard) : jobs_(jobs), checkpoints_(checkpoints) {
    for (std::size_t job = 0; job < jobs.size(); ++job) blocks_.push_back(dealt(*jobs[job], job, shard));
  }

  [[nodiscard]] BlockSet::Run blocks(std::size_t job) const { return blocks_[job]; }
  [[nodiscard]] const std::vector<BlockSet::Run>& blocks() const { return blocks_; }
  [[nodiscard]] std::uint64_t count() const {
    std::uint64_t sum = 0;
    for (std::size_t job = 0; job < jobs_.size(); ++job) sum += count(job);
    return sum;
  }
  [[nodiscard]] std::uint64_t count(std::size_t job) const { return blocks(job).second - blocks(job).first; }
  [[nodiscard]] std::uint64_t count_done() const {
    std::uint64_t sum = 0;
    for (std::size_t job = 0; job < jobs_.size(); ++job) sum += count_done(job);
    return sum;
  }
  [[nodiscard]] std::uint64_t count_done(std::size_t job) const {
    return checkpoints_.done(job).within(blocks(job)).size();
  }
  [[nodiscard]] double cost_left(std::size_t number) const {
    const Job& job = *jobs_[number];
    const auto each = job.blocks_per_part();
    const auto [first, end] = blocks(number);
    double sum = 0;
    for (std::uint64_t at = first; at < end;) {
      const auto part = job.part_of(at);
      const BlockSet::Run run{at, std::min<std::uint64_t>(end, (part + 1) * each)};
      sum +=
          job.cost(part) * static_cast<double>(run.second - run.first - checkpoints_.done(number).within(run).size());
      at = run.second;
    }
    return sum;
  }

 private:
  const Jobs& jobs_;
  const Checkpoints& checkpoints_;
  std::vector<BlockSet::Run> blocks_;  ///< per job
};

/// What the rest of a run takes, to an order of magnitude. What methods from outside take is not known.
std::string estimate(const Plan& plan, const Share& share, const Extent& extent) {
  constexpr double bytes_of_row = 300;      // of CSV
  constexpr double bytes_of_result = 20e3;  // the histograms of a row, in memory and in files of blocks
  constexpr double bytes_of_program = 30e6;
  double nanoseconds = 0;
  for (std::size_t job = 0; job < plan.studies.size(); ++job)
    if (plan.jobs[job]->is_estimable()) nanoseconds += share.cost_left(job);
  const double results = bytes_of_result * static_cast<double>(extent.rows);
  const double tables = bytes_of_row * static_cast<double>(extent.rows) + static_cast<double>(extent.input_bytes);
  constexpr double megabyte = 1e6;
  return fmt::format("{:.1f} s on one thread, {:.2f} MB of disk, {:.0f} MB of memory", nanoseconds * 1e-9,
                     (tables + results) / megabyte, (bytes_of_program + results) / megabyte);
}

void describe(const RunRequest& request, const Plan& plan, bool already_complete) {
  Extent extent;
  for (const auto& job : plan.jobs) extent += job->extent();
  Checkpoints checkpoints(plan.jobs, {request.out / "blocks", "", plan.manifest, plan.reference, machine_of(request)});
  const Found found = find_blocks(request.out / "blocks");
  require_same(found, plan, Exit::usage);
  for (const auto& line : checkpoints.load(found, Checkpoints::Whose::all)) note(line);
  const Share share(plan.jobs, checkpoints, request.shard.value_or(Shard()));
  std::string left_out;
  for (std::size_t job = 0; job < plan.jobs.size(); ++job)
    if (!already_complete && !plan.jobs[job]->is_estimable())
      left_out += fmt::format("no estimate  for {}: how long it searches depends on what it finds\n",
                              printable(plan.job_names[job]));
  fmt::print("studies      {}\ncells        {}\nevaluations  {}\n", plan.studies.size(), extent.cells,
             extent.evaluations);
  fmt::print("blocks       {}{}, {} of them done\n", share.count(),
             request.shard ? fmt::format(" of {}", name_of(request.shard)) : "",
             already_complete ? share.count() : share.count_done());
  if (!already_complete) fmt::print("estimated    {}\n", estimate(plan, share, extent));
  fmt::print("{}out          {}{}\n", left_out, printable(request.out.string()),
             already_complete ? " (already complete)" : "");
}

/// Checks before the first block, not after hours, whether the machine is fit for timings.
void require_machine(const Jobs& jobs, const Share& share) {
  for (std::size_t number = 0; number < jobs.size(); ++number)
    if (const auto [first, end] = share.blocks(number); first < end) jobs[number]->require_machine();
}

/// The work of this process that is left, study by study.
std::vector<StudyWork> work_left(const Plan& plan, const Share& share) {
  std::vector<StudyWork> all;
  for (std::size_t job = 0; job < plan.jobs.size(); ++job)
    all.push_back({plan.job_names[job], share.count(job) - share.count_done(job), share.cost_left(job),
                   plan.jobs[job]->exclusive()});
  return all;
}

/// Returns the seconds that it took.
double work(const RunRequest& request, const Plan& plan, Checkpoints& checkpoints) {
  const Jobs& jobs = plan.jobs;
  const Share share(jobs, checkpoints, request.shard.value_or(Shard()));
  require_machine(jobs, share);
  if (request.telling == Telling::json)
    note_event(beginning_json(jobs.size(), cells_of(jobs), share.count(), share.count_done()));
  Progress progress(work_left(plan, share), request.telling);
  const auto run_one = [&](std::size_t number, std::uint64_t block) {
    if (interrupted() || checkpoints.done(number, block)) return;
    auto result = jobs[number]->run_block(block);
    if (interrupted()) return;  // the block may be incomplete
    checkpoints.add(number, block, std::move(result));
    progress.add(number, jobs[number]->cost(jobs[number]->part_of(block)));
  };
  std::vector<std::size_t> shared;
  std::vector<std::uint64_t> ends;  // of their blocks, numbered through; a list of all blocks might not fit in memory
  for (std::size_t number = 0; number < jobs.size(); ++number) {
    const auto [first, end] = share.blocks(number);
    if (jobs[number]->exclusive() || first == end) continue;
    shared.push_back(number);
    ends.push_back((ends.empty() ? 0 : ends.back()) + (end - first));
  }
  const auto threads = request.jobs > 0 ? static_cast<std::size_t>(request.jobs)
                                        : static_cast<std::size_t>(tbb::info::default_concurrency());
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto run_range = [&](std::uint64_t begin, std::uint64_t end) {
      for (auto k = begin; k < end && !interrupted(); ++k) {
        const auto index = static_cast<std::size_t>(std::ranges::upper_bound(ends, k) - ends.begin());
        run_one(shared[index], share.blocks(shared[index]).second - (ends[index] - k));
      }
    };
    parallel_ranges(ends.empty() ? 0 : ends.back(), run_range);
  }
  for (const auto& [number, block] : exclusive_order(jobs, share.blocks())) run_one(number, block);
  return progress.seconds();
}

/// Completes the bundle when the blocks of this process are done, unless blocks of other shards are missing.
Outcome complete(const RunRequest& request, const Plan& plan, RunFolder& place, Checkpoints& checkpoints) {
  const auto lock = place.lock_bundle();
  if (request.shard) {
    if (place.directory().manifest().state == bundle::complete) return {};  // another shard did it
    const Found found = find_blocks(place.directory().blocks());
    require_same(found, plan, Exit::usage);
    for (const auto& line : checkpoints.load(found, Checkpoints::Whose::all)) note(line);
  }
  if (!checkpoints.all_settled()) {
    if (request.telling == Telling::text)
      note(fmt::format("{}: {} is done, others are not", request.out.string(), name_of(request.shard)));
    Outcome outcome;
    outcome.ending = Ending::partial;
    return outcome;
  }
  const auto tables = written_tables(request, plan);
  assemble(request, tables, plan, place.directory());
  return outcome_of(plan.jobs, tables);
}

}  // namespace

Outcome run(const RunRequest& request) {
  const Plan plan(request);
  tell_unasked(request, plan);
  const auto before = existing(request, plan);
  const bool is_complete = before && before->state == bundle::complete;
  if (request.dry_run) {
    describe(request, plan, is_complete);
    return {};
  }
  const auto already_complete = [&] {
    Outcome outcome;
    auto& findings = outcome.findings =
        bundle::verify(request.out, [&](const std::string&, const std::string&) { return expected_of(request); });
    if (!findings.empty())
      findings.push_back(request.out.string() +
                         ": complete, but not as it was written; restore it, or remove it and run the command again");
    else if (request.telling == Telling::text)
      note(request.out.string() + ": already complete, nothing to do");
    return outcome;
  };
  if (is_complete && !bundle::is_inner_folder(request.out / bundle::blocks_name)) return already_complete();

  RunFolder place(request, plan);
  if (!place.begin()) return already_complete();
  Checkpoints checkpoints(plan.jobs, place.owner());
  for (const auto& line :
       checkpoints.load(place.found(), request.shard ? Checkpoints::Whose::own : Checkpoints::Whose::all))
    note(line);
  const auto ending =
      fmt::format("{}: interrupted before the results were complete; run the same command again", request.out.string());
  work_begins(ending);
  const double seconds = work(request, plan, checkpoints);
  if (interrupted()) {
    checkpoints.checkpoint();
    throw Failure(Exit::interrupted, ending);
  }
  if (request.shard)
    checkpoints.checkpoint();
  else
    checkpoints.settle();
  auto outcome = complete(request, plan, place, checkpoints);
  outcome.seconds = seconds;
  return outcome;
}

}  // namespace bezierbench::run
