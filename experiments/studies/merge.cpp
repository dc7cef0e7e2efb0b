// SPDX-License-Identifier: MIT
#include "experiments/studies/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>
#include <tuple>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/lock_file.hpp"
#include "experiments/bundle/machine.hpp"
#include "experiments/failure.hpp"
#include "experiments/studies/notes.hpp"
#include "experiments/studies/plan.hpp"

namespace bezierbench::studies {
namespace {

namespace fs = std::filesystem;

constexpr const char* machine_name = "machine.json";
constexpr const char* methods_name = "methods.csv";

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Failure(Exit::finding, fmt::format("{}: {}", path.string(), why));
}

/// One of the bundles, locked while it is read.
struct Source {
  explicit Source(const fs::path& folder) : path(folder), directory(bundle::BundleDirectory::open(folder)) {
    std::error_code ignored;
    if (fs::is_directory(directory.blocks(), ignored)) {
      lock = std::make_unique<bundle::LockFile>(directory.blocks() / "run.lock");
      if (!lock->try_lock(bundle::Sharing::exclusive))
        throw Failure(Exit::input_output,
                      fmt::format("{}: a run is at work there; wait for it, or stop it", path.string()));
    }
    manifest = directory.manifest();
    (void)directory.read_listed("suite.toml");
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
  if (source.directory.read_listed(methods_name) != request.methods_csv)
    refuse(source.path, "lists other methods than this program has; merge with the program that made it");
  studies::require_same(source.found, plan, Exit::finding);
}

/// What machine.json says is what SHA256SUMS lists or, where a merge into one of the bundles was killed, what another
/// bundle has: it was put there from that one.
void refuse_damaged_machines(const std::vector<Source>& sources) {
  const auto listed = [](const Source& one) { return one.directory.read_if_listed(machine_name).has_value(); };
  for (const auto& source : sources)
    if (!listed(source) && std::ranges::none_of(sources, [&](const Source& other) {
          return other.machine_text == source.machine_text && listed(other);
        }))
      (void)source.directory.read_listed(machine_name);  // says why
}

/// Times of another machine than the bundle's last do not count: they were to be taken again.
void drop_stale_times(Source& source, const Jobs& jobs) {
  for (auto& [path, file] : source.found.readable)
    if (file.machine != source.machine)
      std::erase_if(file.records, [&](const auto& one) { return one.job < jobs.size() && jobs[one.job]->exclusive(); });
}

std::string study_of(const RunRequest& request, std::size_t job) {
  for (const auto& suite : request.suites) {
    if (job < suite.studies.size()) return suite.studies[job].id;
    job -= suite.studies.size();
  }
  return "?";
}

/// Every block is in one bundle at most.
void refuse_overlaps(const std::vector<Source>& sources, const RunRequest& request, std::size_t jobs) {
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
                           study_of(request, job)));
      seen[job].insert(here[job]);
    }
  }
}

void refuse_gaps(const Ledger& ledger, const Plan& plan, const RunRequest& request) {
  std::uint64_t all = 0;
  std::uint64_t there = 0;
  std::optional<std::size_t> first;
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    all += plan.jobs[job]->blocks();
    there += ledger.settled(job).size();
    if (!first && ledger.settled(job).size() != plan.jobs[job]->blocks()) first = job;
  }
  if (first)
    refuse(request.out,
           fmt::format("{} of {} blocks are missing, the first of study \"{}\"; name all shards, or finish "
                       "theirs with bezierbench run --shard",
                       all - there, all, study_of(request, *first)));
}

/// The bundle whose machine.json goes into the result: the one with the times, or else the one with the first block,
/// whatever the order in which they are named.
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

}  // namespace

Findings merge(RunRequest request, const std::vector<fs::path>& bundles) {
  std::vector<Source> sources;
  for (const auto& path : bundles) {
    std::error_code ignored;
    for (const auto& other : sources)
      if (fs::equivalent(other.path, path, ignored)) refuse(path, "named twice; name every shard once");
    sources.emplace_back(path);
  }
  const auto with_blocks = std::ranges::find_if(sources, [](const Source& one) { return !one.found.readable.empty(); });
  if (with_blocks != sources.end() &&
      with_blocks->found.readable.front().file.reference == name(reference::Tier::exact))
    request.tier = reference::Tier::exact;
  const Plan plan(request);
  for (auto& source : sources) {
    require_same(source, plan, request);
    if (source.manifest.state == bundle::complete)
      refuse(source.path, "is complete already; there is nothing to join it with");
    drop_stale_times(source, plan.jobs);
  }
  refuse_damaged_machines(sources);
  refuse_overlaps(sources, request, plan.jobs.size());
  const Source& machine = with_machine(sources, plan.jobs);
  Ledger ledger(plan.jobs, {{}, "", plan.manifest, plan.reference, machine.machine});
  for (const auto& source : sources)
    for (const auto& line : ledger.load(source.found, Ledger::Whose::all)) note(line);
  refuse_gaps(ledger, plan, request);

  std::error_code ignored;
  const bool in_place = std::ranges::any_of(
      sources, [&](const Source& source) { return fs::equivalent(source.path, request.out, ignored); });
  if (!in_place && !find_blocks(request.out / "blocks").readable.empty())
    refuse(request.out, "holds blocks of its own; name it among the bundles, or choose another --out");
  const auto directory = bundle::BundleDirectory::create(request.out);
  directory.write("suite.toml", plan.suite_text);
  directory.write(machine_name, machine.machine_text);
  directory.write(methods_name, request.methods_csv);
  return assemble(request, plan, directory);
}

}  // namespace bezierbench::studies
