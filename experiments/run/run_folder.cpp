// SPDX-License-Identifier: MIT
#include "experiments/run/run_folder.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <system_error>
#include <thread>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/check/schema.hpp"
#include "experiments/bundle/check/table_schema.hpp"
#include "experiments/bundle/folder.hpp"
#include "experiments/bundle/machine.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/run/notes.hpp"

namespace bezierbench::run {
namespace {

std::string machine_now(const RunRequest& request) {
  return bundle::machine_json(request.build, request.counters, request.host_name);
}

namespace fs = std::filesystem;

constexpr auto patience = std::chrono::milliseconds(20);

/// Creates blocks/ for locks and blocks. In a complete bundle it exists for a moment only.
bundle::BundleDirectory with_blocks(const fs::path& out) {
  auto directory = bundle::BundleDirectory::create(out);
  std::error_code error;
  fs::create_directories(directory.blocks(), error);
  if (error)
    throw Failure(Exit::input_output, fmt::format("{}: cannot be created: {}; choose another --out",
                                                  directory.blocks().string(), error.message()));
  return directory;
}

std::string writer_of(const std::optional<Shard>& shard) {
  return shard ? fmt::format("shard-{}-of-{}", shard->number, shard->count) : "whole";
}

/// Whether a timing is missing among the blocks that this machine ran.
bool timings_missing(const Jobs& jobs, const Found& found, const std::string& machine) {
  for (std::size_t job = 0; job < jobs.size(); ++job) {
    if (!jobs[job]->exclusive()) continue;
    BlockSet there;
    for (const auto& [path, file] : found.readable)
      for (const auto& record : file.records)
        if (record.job == job && file.machine == machine) there.insert(BlockSet(record.blocks));
    if (there.size() != jobs[job]->blocks()) return true;
  }
  return false;
}

}  // namespace

std::string machine_of(const RunRequest& request) {
  const auto path = request.out / machine_name;
  std::error_code ignored;
  const bool is_there = fs::exists(fs::symlink_status(path, ignored));
  return bundle::machine_fingerprint(is_there ? bundle::read_bundle_file(path) : machine_now(request));
}

RunFolder::RunFolder(const RunRequest& request, const Plan& plan)
    : request_(request),
      plan_(plan),
      directory_(with_blocks(request.out)),
      writer_(writer_of(request.shard)),
      run_lock_(directory_.blocks() / "run.lock"),
      bundle_lock_(directory_.blocks() / "bundle.lock") {
  claim(run_lock_, request.shard ? bundle::Sharing::shared : bundle::Sharing::exclusive,
        request.shard ? "an unsharded run" : "another run");
  if (request.shard) {
    shard_lock_.emplace(directory_.blocks() / (writer_ + ".lock"));
    claim(*shard_lock_, bundle::Sharing::exclusive,
          fmt::format("the same shard {}/{}", request.shard->number, request.shard->count));
  }
  if (run_lock_.unsupported())
    note(fmt::format("{}: this file system has no locks; see to it that no other run does the same work here",
                     request.out.string()));
}

void RunFolder::claim(bundle::LockFile& lock, bundle::Sharing sharing, const std::string& holder) {
  if (!lock.try_lock(sharing))
    throw Failure(Exit::input_output, fmt::format("{}: {} is at work there, on this machine or another; wait for it, "
                                                  "stop it, or choose another --out",
                                                  request_.out.string(), holder));
}

RunFolder::Guard RunFolder::lock_bundle() {
  while (!bundle_lock_.try_lock(bundle::Sharing::exclusive)) {
    if (interrupted())
      throw Failure(Exit::interrupted,
                    fmt::format("{}: interrupted while another shard wrote there; run the same command again",
                                request_.out.string()));
    std::this_thread::sleep_for(patience);
  }
  return Guard(bundle_lock_);
}

bool RunFolder::begin() {
  const auto lock = lock_bundle();
  if (directory_.has(bundle::manifest_name)) {
    const auto theirs = directory_.manifest();
    if (theirs.state == bundle::complete) {
      directory_.clear_away();  // blocks/, which a killed run left
      return false;
    }
    refuse_foreign(request_, bundle::is_table_name);
    (void)directory_.read_listed(suite_name);
    for (const auto& [name, ours] : lists_of(request_))
      if (directory_.read_listed(name) != ours)
        throw Failure(Exit::usage, fmt::format("{}: lists other {} than this program has; choose another --out",
                                               (directory_.path() / name).string(), fs::path(name).stem().string()));
  } else {
    refuse_foreign(request_, bundle::is_table_name);
    directory_.write(suite_name, plan_.suite_text);
    directory_.write(machine_name, machine_now(request_));
    for (const auto& [name, ours] : lists_of(request_)) directory_.write(name, ours);
    directory_.finish(plan_.manifest);
  }
  found_ = find_blocks(directory_.blocks());
  require_same(found_, plan_, Exit::usage);
  choose_machine();
  return true;
}

void RunFolder::choose_machine() {
  // Empty where it is damaged, or where a run was killed just after it had continued one of another machine.
  auto theirs = directory_.read_if_listed(machine_name);
  if (theirs && bundle::machine_fault(*theirs, machine_name)) theirs.reset();
  machine_ = bundle::machine_fingerprint(theirs.value_or(""));
  const bool times_here = !request_.shard || request_.shard->number == 1;
  if (!theirs)
    note(fmt::format("{}: damaged or unfinished; written anew", (directory_.path() / machine_name).string()));
  else if (!times_here || !timings_missing(plan_.jobs, found_, machine_))
    return;
  const std::string ours = machine_now(request_);
  if (bundle::machine_fingerprint(ours) == machine_) return;
  directory_.write(machine_name, ours);
  directory_.finish(plan_.manifest);
  machine_ = bundle::machine_fingerprint(ours);
}

Checkpoints::Owner RunFolder::owner() const {
  return {directory_.blocks(), writer_, plan_.manifest, plan_.reference, machine_, request_.checkpoint};
}

}  // namespace bezierbench::run
