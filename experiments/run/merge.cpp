// SPDX-License-Identifier: MIT
#include "experiments/run/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>
#include <tuple>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/check/checked_reader.hpp"
#include "experiments/bundle/check/method_digest.hpp"
#include "experiments/bundle/check/schema.hpp"
#include "experiments/bundle/check/table_schema.hpp"
#include "experiments/bundle/check/verify.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/folder.hpp"
#include "experiments/bundle/lock_file.hpp"
#include "experiments/bundle/machine.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/expected.hpp"
#include "experiments/run/merge_target.hpp"
#include "experiments/run/notes.hpp"
#include "experiments/run/plan.hpp"

namespace bezierbench::run {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Failure(Exit::finding, fmt::format("{}: {}", path.string(), why));
}

/// One of the bundles, locked while it is read.
struct Source {
  explicit Source(const fs::path& folder) : path(folder), directory(bundle::BundleDirectory::open(folder)) {
    if (bundle::is_inner_folder(directory.blocks())) lock = lock_of_run(directory);
    manifest = directory.manifest();
    (void)directory.read_listed(suite_name);
    machine_text = directory.read(machine_name);
    machine = bundle::machine_fingerprint(machine_text);
    found = find_blocks(directory.blocks());
  }

  fs::path path;
  bundle::BundleDirectory directory;
  std::unique_ptr<bundle::LockFile> lock;
  bundle::Manifest manifest;
  std::string machine_text;
  std::string machine;  ///< fingerprint
  Found found;
};

void require_same(const Source& source, const Plan& plan, const RunRequest& request) {
  if (const auto why = difference(source.manifest, plan.manifest))
    refuse(source.path, fmt::format("holds results of {}; merge what one program made of one suite", *why));
  for (const auto& [name, ours] : lists_of(request))
    if (source.directory.read_listed(name) != ours)
      refuse(source.path, fmt::format("lists other {} than this program has; merge with the program that made it",
                                      fs::path(name).stem().string()));
  require_same(source.found, plan, Exit::finding);
}

/// The machine.json that SHA256SUMS lists. A merge into one of the bundles may have been killed after it had put
/// another bundle's machine.json there; then that one counts.
void refuse_damaged_machines(const std::vector<Source>& sources) {
  const auto listed = [](const Source& one) { return one.directory.read_if_listed(machine_name).has_value(); };
  for (const auto& source : sources)
    if (!listed(source) && std::ranges::none_of(sources, [&](const Source& other) {
          return other.machine_text == source.machine_text && listed(other);
        }))
      (void)source.directory.read_listed(machine_name);  // says why
  for (const auto& source : sources)
    if (const auto why = bundle::machine_fault(source.machine_text, (source.path / machine_name).string()))
      throw Failure(Exit::finding, fmt::format("{}; restore it", *why));
}

/// Times of a machine other than the bundle's last do not count, because that machine was to take them again.
void drop_stale_times(Source& source, const Jobs& jobs) {
  for (auto& [path, file] : source.found.readable)
    if (file.machine != source.machine)
      std::erase_if(file.records, [&](const auto& one) { return one.job < jobs.size() && jobs[one.job]->exclusive(); });
}

/// Checks that every block is in one bundle at most.
void refuse_overlaps(const std::vector<Source>& sources, const Plan& plan) {
  const std::size_t jobs = plan.jobs.size();
  std::vector<BlockSet> seen(jobs);
  for (std::size_t k = 0; k < sources.size(); ++k) {
    std::vector<BlockSet> here(jobs);
    for (const auto& [path, file] : sources[k].found.readable)
      for (const auto& record : file.records)
        if (record.job < jobs) here[record.job].insert(BlockSet(record.blocks));
    for (std::size_t job = 0; job < jobs; ++job) {
      if (seen[job].overlaps(here[job]))
        refuse(sources[k].path,
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
                       "theirs with bezierbench run --shard",
                       all - there, all, plan.job_names[*first]));
}

/// The bundle whose machine.json goes into the result: the one with the times, or else the one with the first block.
/// The order in which bundles are named does not matter.
const Source& with_machine(const std::vector<Source>& sources, const Jobs& jobs) {
  const auto first_block = [&](const Source& source) {
    std::tuple<bool, std::uint64_t, std::uint64_t> least{true, jobs.size(), 0};
    for (const auto& [path, file] : source.found.readable)
      for (const auto& record : file.records)
        if (record.job < jobs.size() && !record.blocks.empty())
          least = std::min(least, {!jobs[record.job]->exclusive(), record.job, record.blocks.front().first});
    return least;
  };
  const Source* times = nullptr;
  for (const auto& source : sources) {
    if (std::get<0>(first_block(source))) continue;
    if (times != nullptr && times->machine != source.machine)
      refuse(source.path, fmt::format("holds times of another machine than {}; times of one run are of one machine",
                                      times->path.string()));
    times = &source;
  }
  return *std::ranges::min_element(sources, {}, first_block);
}

/// A table that cannot be read is not what was written.
bool has_its_digest(const Source& source) {
  try {
    return bundle::accuracy_digest(source.path) == source.manifest.accuracy_digest;
  } catch (const Failure&) {
    return false;
  }
}

/// The files of a complete bundle, as they were written.
Files files_of(const Source& source) {
  if (!has_its_digest(source))
    refuse(source.path, "is complete, but its accuracy digest is that of other files; see bezierbench verify");
  bundle::CheckedReader reader(source.path, bundle::Damage::refused);
  Files files;
  for (const auto& [name, digest] : bundle::parse_sums(source.directory.read(bundle::sums_name)).digests) {
    if (name == bundle::manifest_name || name == bundle::digests_name) continue;  // which finish() writes
    if (name != suite_name && name != machine_name && !bundle::is_table_name(name))
      refuse(source.path / name, "is listed in SHA256SUMS, but no file of a bundle; see bezierbench verify");
    files.emplace_back(name, reader.read(name));
  }
  return files;
}

/// The complete bundle among them, null where there is none: one shard may have all blocks of a run with few studies.
/// Refuses blocks in other bundles, which it has as well.
const Source* the_complete_one(const std::vector<Source>& sources) {
  const Source* whole = nullptr;
  for (const auto& source : sources)
    if (source.manifest.state == bundle::complete) {
      if (whole != nullptr)
        refuse(source.path,
               fmt::format("is complete already, and so is {}; name every shard once", whole->path.string()));
      whole = &source;
    }
  if (whole == nullptr) return nullptr;
  if (sources.size() == 1) refuse(whole->path, "is complete already; there is nothing to join it with");
  for (const auto& source : sources)
    if (&source != whole && !(source.found.readable.empty() && source.found.damaged.empty()))
      refuse(source.path, fmt::format("holds blocks that {} has as well, which is complete already; name every shard "
                                      "once",
                                      whole->path.string()));
  return whole;
}

/// The bundle of all blocks.
struct Joined {
  Files files;  ///< the tables and the rest
  Outcome outcome;
};

Joined joined(std::vector<Source>& sources, const Plan& plan, const RunRequest& request) {
  refuse_damaged_machines(sources);
  for (auto& source : sources) drop_stale_times(source, plan.jobs);
  refuse_overlaps(sources, plan);
  const Source& machine = with_machine(sources, plan.jobs);
  Checkpoints checkpoints(plan.jobs, {{}, "", plan.manifest, plan.reference, machine.machine});
  for (const auto& source : sources)
    for (const auto& line : checkpoints.load(source.found, Checkpoints::Whose::all)) note(line);
  refuse_gaps(checkpoints, plan, request);
  Joined bundle{.files = {{suite_name, plan.suite_text}, {machine_name, machine.machine_text}}, .outcome = {}};
  for (auto& list : lists_of(request)) bundle.files.push_back(std::move(list));
  const tables::Tables tables = written_tables(request, plan);
  for (const auto& [file, table] : tables.all()) bundle.files.emplace_back(file, table.text());
  bundle.outcome = outcome_of(plan.jobs, tables);
  return bundle;
}

std::vector<Source> opened(const std::vector<fs::path>& bundles) {
  std::vector<Source> sources;
  for (const auto& path : bundles) {
    std::error_code ignored;
    for (const auto& other : sources)
      if (fs::equivalent(other.path, path, ignored)) refuse(path, "named twice; name every shard once");
    sources.emplace_back(path);
  }
  return sources;
}

}  // namespace

Outcome merge(RunRequest request, const std::vector<fs::path>& bundles) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  auto sources = opened(bundles);
  const auto with_blocks = std::ranges::find_if(sources, [](const Source& one) { return !one.found.readable.empty(); });
  if (with_blocks != sources.end() &&
      with_blocks->found.readable.front().file.reference == name(reference::Tier::exact))
    request.tier = reference::Tier::exact;
  const Plan plan(request);
  for (const auto& source : sources) require_same(source, plan, request);
  const Source* whole = the_complete_one(sources);
  auto [files, outcome] = whole != nullptr ? Joined{files_of(*whole), {}} : joined(sources, plan, request);

  std::error_code ignored;
  const auto target = std::ranges::find_if(
      sources, [&](const Source& source) { return fs::equivalent(source.path, request.out, ignored); });
  const bool is_source = target != sources.end();
  put_whole(request, plan, files, is_source, is_source && target->lock != nullptr);
  if (whole != nullptr) {
    outcome.findings = bundle::verify(request.out, [&](const auto&, const auto&) { return expected_of(request); });
    if (request.telling == Telling::text)
      note(fmt::format("{}: {} was the whole bundle already", request.out.string(), whole->path.string()));
  }
  outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return outcome;
}

}  // namespace bezierbench::run
