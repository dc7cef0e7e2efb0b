// SPDX-License-Identifier: MIT
#include "experiments/run/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <thread>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/machine.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/run/progress.hpp"

namespace bezierbench::run {
namespace {

namespace fs = std::filesystem;

constexpr auto patience = std::chrono::milliseconds(20);

std::string machine_now(const RunRequest& request) {
  return bundle::machine_json(request.build, request.counters, request.host_name);
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

std::string writer_of(const std::optional<Shard>& shard) {
  return shard ? fmt::format("shard-{}-of-{}", shard->number, shard->count) : "whole";
}

WholeBundle written(const tables::Tables& tables) {
  WholeBundle whole;
  for (const auto& [file, table] : tables.all()) {
    auto [text, digests] = table.written();
    whole.files.emplace_back(file, std::move(text));
    std::ranges::move(digests, std::back_inserter(whole.digests));
  }
  return whole;
}

void RunFolder::look() {
  has_blocks_ = bundle::is_inner_folder(blocks());
  manifest_.reset();
  if (has_blocks_ || bundle::is_there(path_ / bundle::manifest_name)) directory_ = bundle::BundleDirectory::open(path_);
  if (bundle::is_there(path_ / bundle::manifest_name)) manifest_ = directory_->manifest();
  if (is_begun() && directory_->has(machine_name))
    machine_ = bundle::machine_fingerprint(directory_->read(machine_name));
}

void RunFolder::require_same(const RunRequest& request, const Plan& plan, const Refusal& refusal) const {
  const auto refuse = [&](const fs::path& path, const std::string& what) {
    throw Failure(refusal.exit, "{}: {}; {}", path.string(), what, refusal.advice);
  };
  if (is_begun())
    if (const auto why = difference(*manifest_, plan.manifest)) refuse(path_, fmt::format("holds results of {}", *why));
  if (is_complete()) return;
  if (is_begun()) {
    (void)directory_->read_listed(suite_name);
    for (const auto& [name, ours] : lists_of(request))
      if (directory_->read_listed(name) != ours)
        refuse(path_ / name, fmt::format("lists other {} than this program has", fs::path(name).stem().string()));
  }
  for (const auto& [path, file] : found_.readable) {
    auto why = difference(file.manifest, plan.manifest);
    if (!why && file.reference != plan.reference)
      why = fmt::format("reference {}, this run has {}", file.reference, plan.reference);
    if (why) refuse(path, fmt::format("holds blocks of {}", *why));
  }
}

void RunFolder::claim(const std::string& name, bundle::Sharing sharing, const std::string& holder) {
  auto& lock = *locks_.emplace_back(std::make_unique<bundle::LockFile>(blocks() / name));
  if (!lock.try_lock(sharing))
    throw Failure(Exit::input_output,
                  "{}: {} is at work there, on this machine or another; wait for it, stop it, or choose another --out",
                  path_.string(), holder);
  if (lock.unsupported() && locks_.size() == 1)
    note(fmt::format("{}: this file system has no locks; see to it that no other run does the same work here",
                     path_.string()));
}

void RunFolder::lock(const std::optional<Shard>& shard) {
  directory_ = bundle::BundleDirectory::create(path_);
  bundle_lock_ = std::make_unique<bundle::LockFile>(blocks() / "bundle.lock");
  claim("run.lock", shard ? bundle::Sharing::shared : bundle::Sharing::exclusive,
        shard ? "an unsharded run" : "another run");
  if (shard)
    claim(writer_of(shard) + ".lock", bundle::Sharing::exclusive,
          fmt::format("the same shard {}/{}", shard->number, shard->count));
}

void RunFolder::lock_for_merge() {
  directory_ = bundle::BundleDirectory::create(path_);
  claim("run.lock", bundle::Sharing::exclusive, "a run");
}

std::shared_ptr<void> RunFolder::lock_bundle() {
  while (!bundle_lock_->try_lock(bundle::Sharing::exclusive)) {
    if (interrupted())
      throw Failure(Exit::interrupted, "{}: interrupted while another shard wrote there; run the same command again",
                    path_.string());
    std::this_thread::sleep_for(patience);
  }
  return {bundle_lock_.get(), [](void* lock) { static_cast<bundle::LockFile*>(lock)->unlock(); }};
}

bool RunFolder::begin(const RunRequest& request, const Plan& plan) {
  if (is_complete() && !has_blocks()) return false;
  lock(request.shard);
  const auto alone = lock_bundle();
  look();  // again, since another process may have written meanwhile
  if (!is_complete()) read_blocks();
  require_same(request, plan, run_refusal);
  if (is_complete()) {
    directory_->clear_away();  // blocks/, which a killed run left
    return false;
  }
  refuse_foreign(
      [](const std::string& name) { return bundle::declared_table(name) != nullptr || bundle::is_curves_name(name); });
  if (is_begun())
    choose_machine(request, plan);
  else
    write_description(request, plan);
  return true;
}

void RunFolder::write_description(const RunRequest& request, const Plan& plan) {
  directory_->write(suite_name, plan.suite_text);
  write_machine(request);
  for (const auto& [name, ours] : lists_of(request)) directory_->write(name, ours);
  directory_->finish(plan.manifest);
}

void RunFolder::write_machine(const RunRequest& request) {
  const std::string ours = machine_now(request);
  directory_->write(machine_name, ours);
  machine_ = bundle::machine_fingerprint(ours);
}

/// Times are of one machine. Where some are missing, this one takes all of them.
void RunFolder::choose_machine(const RunRequest& request, const Plan& plan) {
  if (directory_->read_if_listed(machine_name)) {
    const bool times_here = !request.shard || request.shard->number == 1;
    if (!times_here || !timings_missing(plan.jobs, found_, machine_) ||
        bundle::machine_fingerprint(machine_now(request)) == machine_)
      return;
  } else {  // damaged, or a run was killed just after it had continued one of another machine
    note(fmt::format("{}: damaged or unfinished; written again", (path_ / machine_name).string()));
  }
  write_machine(request);
  directory_->finish(plan.manifest);
}

void RunFolder::refuse_foreign(const std::function<bool(const std::string&)>& is_own) const {
  const std::array<std::string_view, 6> always{bundle::manifest_name, bundle::sums_name, bundle::blocks_name,
                                               bundle::digests_name,  suite_name,        machine_name};
  const auto found = bundle::list_folder(path_);
  for (const auto* names : {&found.files, &found.others})
    for (const auto& name : *names)
      if (!name.starts_with('.') && std::ranges::find(always, name) == always.end() && !is_own(name))
        throw Failure(Exit::input_output,
                      "{}: is not a file that this run writes; move it away, or choose another --out",
                      (path_ / name).string());
}

void RunFolder::complete(const Plan& plan, const WholeBundle& whole) {
  refuse_foreign([&](const std::string& name) {
    return name == methods_name || name == generators_name || bundle::is_curves_name(name) ||
           std::ranges::any_of(whole.files, [&](const auto& file) { return file.first == name; });
  });
  for (const auto& [name, bytes] : whole.files) directory_->write(name, bytes);
  bundle::Manifest manifest = plan.manifest;
  manifest.state = bundle::complete;
  directory_->finish(manifest, whole.digests);
}

void RunFolder::require_equal(const WholeBundle& whole) const {
  for (const auto& [name, bytes] : whole.files)
    if (!directory_->has(name) || directory_->read(name) != bytes)
      throw Failure(Exit::usage, "{}: is complete already, with another {}; choose another --out or move it away",
                    path_.string(), name);
}

}  // namespace bezierbench::run
