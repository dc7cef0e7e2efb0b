// SPDX-License-Identifier: MIT
// Joins the bundles of shards.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <system_error>
#include <tuple>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/check/verify.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/plan.hpp"
#include "experiments/run/progress.hpp"
#include "experiments/run/run.hpp"
#include "experiments/run/run_folder.hpp"

namespace bezierbench::run {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Failure(Exit::finding, "{}: {}", path.string(), why);
}

/// One of the bundles, locked while it is read.
struct Source {
  explicit Source(const fs::path& path) : folder(path) {
    if (!folder.is_begun())
      throw Failure(Exit::input_output, "{}: is not a bundle; give a folder that `bezierbench run` wrote",
                    path.string());
    if (folder.has_blocks()) folder.lock_for_merge();
    machine_text = folder.directory().read_listed(machine_name);
    folder.read_blocks();
  }
  [[nodiscard]] const fs::path& path() const { return folder.path(); }
  [[nodiscard]] const Found& found() const { return folder.found(); }

  RunFolder folder;
  std::string machine_text;
};

/// Times of a machine other than the bundle's last do not count, because that machine was to take them again.
void drop_stale_times(Source& source, const Jobs& jobs) {
  for (auto& [path, file] : source.folder.found().readable)
    if (file.machine != source.folder.machine())
      std::erase_if(file.records, [&](const auto& one) { return one.job < jobs.size() && jobs[one.job]->exclusive(); });
}

/// Checks that every block is in one bundle at most.
void refuse_overlaps(const std::vector<Source>& sources, const Plan& plan) {
  const std::size_t jobs = plan.jobs.size();
  std::vector<BlockSet> seen(jobs);
  for (std::size_t k = 0; k < sources.size(); ++k) {
    std::vector<BlockSet> here(jobs);
    for (const auto& [path, file] : sources[k].found().readable)
      for (const auto& record : file.records)
        if (record.job < jobs) here[record.job].insert(BlockSet(record.blocks));
    for (std::size_t job = 0; job < jobs; ++job) {
      if (seen[job].overlaps(here[job]))
        refuse(sources[k].path(),
               fmt::format("holds blocks of study \"{}\" that another of the bundles has as well; name "
                           "every shard once",
                           plan.job_names[job]));
      seen[job].insert(here[job]);
    }
  }
}

void refuse_gaps(const Checkpoints& checkpoints, const Plan& plan, const RunRequest& request) {
  std::uint64_t all = 0;
  std::uint64_t there = 0;
  std::optional<std::size_t> first;
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    all += plan.jobs[job]->blocks();
    there += checkpoints.settled(job).size();
    if (!first && checkpoints.settled(job).size() != plan.jobs[job]->blocks()) first = job;
  }
  if (first)
    refuse(request.out,
           fmt::format("{} of {} blocks are missing, the first of study \"{}\"; name all shards, or finish "
                       "theirs with `bezierbench run --shard`",
                       all - there, all, plan.job_names[*first]));
}

/// The bundle whose machine.json goes into the result: the one with the times, or else the one with the first block.
/// The order in which bundles are named does not matter.
const Source& with_machine(const std::vector<Source>& sources, const Jobs& jobs) {
  const auto first_block = [&](const Source& source) {
    std::tuple<bool, std::uint64_t, std::uint64_t> least{true, jobs.size(), 0};
    for (const auto& [path, file] : source.found().readable)
      for (const auto& record : file.records)
        if (record.job < jobs.size() && !record.blocks.empty())
          least = std::min(least, {!jobs[record.job]->exclusive(), record.job, record.blocks.front().first});
    return least;
  };
  const Source* times = nullptr;
  for (const auto& source : sources) {
    if (std::get<0>(first_block(source))) continue;
    if (times != nullptr && times->folder.machine() != source.folder.machine())
      refuse(source.path(), fmt::format("holds times of another machine than {}; times of one run are of one machine",
                                        times->path().string()));
    times = &source;
  }
  return *std::ranges::min_element(sources, {}, first_block);
}

/// The files of a complete bundle, as they were written.
WholeBundle copy_of(const Source& source) {
  const auto& bundle = source.folder.directory();
  const std::string digests = bundle.read_listed(bundle::digests_name);
  if (bundle::sha256_hex(digests) != source.folder.manifest().accuracy_digest)
    refuse(source.path(), "is complete, but its accuracy digest is that of other files; see `bezierbench verify`");
  WholeBundle whole{.files = {}, .digests = bundle::parse_digests(bundle::parse_csv(digests, bundle::digests_name))};
  for (const auto& [name, digest] : bundle::parse_sums(bundle.read(bundle::sums_name)).digests) {
    if (name == bundle::manifest_name || name == bundle::digests_name) continue;  // which finish() writes
    if (name != suite_name && name != machine_name && bundle::declared_table(name) == nullptr)
      refuse(source.path() / name, "is listed in SHA256SUMS, but no file of a bundle; see `bezierbench verify`");
    whole.files.emplace_back(name, bundle.read_listed(name));
  }
  return whole;
}

/// The complete bundle among them, null where there is none: one shard may have all blocks of a run with few studies.
/// Refuses blocks in other bundles, which it has as well.
const Source* the_complete_one(const std::vector<Source>& sources) {
  const Source* whole = nullptr;
  for (const auto& source : sources)
    if (source.folder.is_complete()) {
      if (whole != nullptr)
        refuse(source.path(),
               fmt::format("is complete already, and so is {}; name every shard once", whole->path().string()));
      whole = &source;
    }
  if (whole == nullptr) return nullptr;
  if (sources.size() == 1) refuse(whole->path(), "is complete already; there is nothing to join it with");
  for (const auto& source : sources)
    if (&source != whole && !source.found().empty())
      refuse(source.path(), fmt::format("holds blocks that {} has as well, which is complete already; name every shard "
                                        "once",
                                        whole->path().string()));
  return whole;
}

/// The bundle of all blocks.
struct Joined {
  WholeBundle whole;
  Outcome outcome;
};

Joined joined(std::vector<Source>& sources, const Plan& plan, const RunRequest& request) {
  for (auto& source : sources) drop_stale_times(source, plan.jobs);
  refuse_overlaps(sources, plan);
  const Source& machine = with_machine(sources, plan.jobs);
  Checkpoints checkpoints(plan.jobs, {{}, "", plan.manifest, plan.reference, machine.folder.machine()});
  for (const auto& source : sources)
    for (const auto& line : checkpoints.load(source.found(), Checkpoints::Whose::all)) note(line);
  refuse_gaps(checkpoints, plan, request);
  const tables::Tables tables = filled_tables(request, plan);
  auto whole = written(tables);
  auto description = lists_of(request);
  description.insert(description.begin(), {{suite_name, plan.suite_text}, {machine_name, machine.machine_text}});
  whole.files.insert(whole.files.begin(), description.begin(), description.end());
  return {std::move(whole), outcome_of(plan.jobs, tables)};
}

std::vector<Source> opened(const std::vector<fs::path>& bundles) {
  std::vector<Source> sources;
  for (const auto& path : bundles) {
    std::error_code ignored;
    for (const auto& other : sources)
      if (fs::equivalent(other.path(), path, ignored)) refuse(path, "named twice; name every shard once");
    sources.emplace_back(path);
  }
  return sources;
}

/// Writes the bundle to the folder `to`, which is not one of those that are merged.
void put(const RunRequest& request, const Plan& plan, const WholeBundle& whole, RunFolder& to) {
  to.require_same(request, plan, run_refusal);
  if (to.is_complete() && !to.has_blocks()) return to.require_equal(whole);
  to.lock_for_merge();
  to.look();  // again, since a run may have written meanwhile
  to.require_same(request, plan, run_refusal);
  if (to.is_complete()) {
    to.require_equal(whole);
    return to.directory().clear_away();
  }
  to.read_blocks();
  if (!to.found().empty())
    refuse(to.path(), "holds blocks of its own; name it among the bundles, or choose another --out");
  to.complete(plan, whole);
}

}  // namespace

Outcome merge(RunRequest request, const std::vector<fs::path>& bundles) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  auto sources = opened(bundles);
  const auto with_blocks =
      std::ranges::find_if(sources, [](const Source& one) { return !one.found().readable.empty(); });
  if (with_blocks != sources.end() &&
      with_blocks->found().readable.front().file.reference == name(reference::Tier::exact))
    request.tier = reference::Tier::exact;
  const Plan plan(request);
  for (const auto& source : sources) source.folder.require_same(request, plan, merge_refusal);
  const Source* complete = the_complete_one(sources);
  auto [whole, outcome] = complete != nullptr ? Joined{copy_of(*complete), {}} : joined(sources, plan, request);

  std::error_code ignored;
  const auto target = std::ranges::find_if(
      sources, [&](const Source& source) { return fs::equivalent(source.path(), request.out, ignored); });
  if (target == sources.end()) {
    RunFolder folder(request.out);
    put(request, plan, whole, folder);
  } else if (&*target != complete) {
    target->folder.complete(plan, whole);
  }
  if (complete != nullptr) {
    outcome.findings =
        bundle::verify(request.out, [&](const auto&, const auto&) { return expected_of(request.suites); });
    if (!request.quiet)
      note(fmt::format("{}: {} was the whole bundle already", request.out.string(), complete->path().string()));
  }
  outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return outcome;
}

}  // namespace bezierbench::run
