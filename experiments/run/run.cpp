// SPDX-License-Identifier: MIT
#include "experiments/run/run.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "experiments/bundle/check/verify.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/blocks/parallel_ranges.hpp"
#include "experiments/run/blocks/share.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/run/plan.hpp"
#include "experiments/run/progress.hpp"
#include "experiments/run/run_folder.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::run {
namespace {

std::string name_of(const std::optional<Shard>& shard) {
  return shard ? fmt::format("shard {}/{}", shard->number, shard->count) : "run";
}

Checkpoints::Owner owner_of(const RunRequest& request, const Plan& plan, const RunFolder& folder) {
  return {folder.blocks(), writer_of(request.shard), plan.manifest,
          plan.reference,  folder.machine(),         request.checkpoint};
}

/// Prints the size of the run and, to an order of magnitude, what the rest of it takes.
void describe(const RunRequest& request, const Plan& plan, RunFolder& folder) {
  constexpr double megabytes_of_program = 30;
  constexpr double megabytes_of_result = 20e-3;  // of a row: its histograms, in memory and in files of blocks

  folder.read_blocks();
  folder.require_same(request, plan, run_refusal);
  Checkpoints checkpoints(plan.jobs, owner_of(request, plan, folder));
  for (const auto& line : checkpoints.load(folder.found(), Checkpoints::Whose::all)) note(line);
  const Share share(plan.jobs, checkpoints, request.shard.value_or(Shard()));
  Extent extent;
  double nanoseconds = 0;
  double megabytes = 0;
  std::string left_out;
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    const auto one = plan.jobs[job]->extent();
    extent += one;
    if (folder.is_complete()) continue;
    megabytes += megabytes_of_result * static_cast<double>(one.rows);
    if (plan.jobs[job]->is_estimable())
      nanoseconds += share.cost_left(job);
    else
      left_out += fmt::format("no estimate  for {}: how long it searches depends on what it finds\n",
                              printable(plan.job_names[job]));
  }
  fmt::print("studies      {}\ncells        {}\nevaluations  {}\n", plan.studies.size(), extent.cells,
             extent.evaluations);
  fmt::print("blocks       {}{}, {} of them done\n", share.count(),
             request.shard ? fmt::format(" of {}", name_of(request.shard)) : "",
             folder.is_complete() ? share.count() : share.count_done());
  fmt::print("estimated    {:.1f} s on one thread, {:.2f} MB of disk, {:.0f} MB of memory\n{}out          {}{}\n",
             nanoseconds / 1e9, megabytes, megabytes_of_program + megabytes, left_out, printable(request.out.string()),
             folder.is_complete() ? " (already complete)" : "");
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
  Progress progress(work_left(plan, share), request.quiet);
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
Outcome complete(const RunRequest& request, const Plan& plan, RunFolder& folder, Checkpoints& checkpoints) {
  const auto alone = folder.lock_bundle();
  if (request.shard) {
    folder.look();
    if (folder.is_complete()) return {};  // another shard did it
    folder.read_blocks();
    folder.require_same(request, plan, run_refusal);
    for (const auto& line : checkpoints.load(folder.found(), Checkpoints::Whose::all)) note(line);
  }
  if (!checkpoints.all_settled()) {
    if (!request.quiet)
      note(fmt::format("{}: {} is done, others are not", request.out.string(), name_of(request.shard)));
    Outcome outcome;
    outcome.ending = Ending::partial;
    return outcome;
  }
  const auto tables = filled_tables(request, plan);
  folder.complete(plan, written(tables));
  return outcome_of(plan.jobs, tables);
}

/// What `verify` finds in a bundle that was complete before.
Outcome already_complete(const RunRequest& request) {
  Outcome outcome;
  outcome.findings = bundle::verify(
      request.out, [&](const auto&, const auto&) { return expected_of(request.suites); }, true);
  if (!outcome.findings.empty())
    outcome.findings.push_back(
        request.out.string() +
        ": complete, but not as it was written; restore it, or remove it and run the command again");
  else if (!request.quiet)
    note(request.out.string() + ": already complete, nothing to do");
  return outcome;
}

}  // namespace

void count(const RunRequest& request) {
  const Plan plan(request);
  for (std::size_t k = 0; k < plan.jobs.size(); ++k) {
    try {
      plan.jobs[k]->count();
    } catch (...) {  // an external method may throw anything
      note(fmt::format("{}: cannot be counted", plan.job_names[k]));
    }
  }
}

Outcome run(const RunRequest& request) {
  const Plan plan(request);
  tell_unasked(request, plan);
  RunFolder folder(request.out);
  folder.require_same(request, plan, run_refusal);
  if (request.dry_run) {
    describe(request, plan, folder);
    return {};
  }
  if (!folder.begin(request, plan)) return already_complete(request);
  Checkpoints checkpoints(plan.jobs, owner_of(request, plan, folder));
  for (const auto& line :
       checkpoints.load(folder.found(), request.shard ? Checkpoints::Whose::own : Checkpoints::Whose::all))
    note(line);
  const auto ending =
      fmt::format("{}: interrupted before the results were complete; run the same command again", request.out.string());
  work_begins(ending);
  const double seconds = work(request, plan, checkpoints);
  if (interrupted()) {
    checkpoints.checkpoint();
    ends_by_itself();
    throw Failure(Exit::interrupted, ending);
  }
  if (request.shard)
    checkpoints.checkpoint();
  else
    checkpoints.settle();
  auto outcome = complete(request, plan, folder, checkpoints);
  outcome.seconds = seconds;
  return outcome;
}

}  // namespace bezierbench::run
