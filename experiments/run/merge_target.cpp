// SPDX-License-Identifier: MIT
#include "experiments/run/merge_target.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/bundle/folder.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::run {
namespace {

/// Whether the result is there already. Refuses a target that must not be overwritten.
bool is_there(const RunRequest& request, const Plan& plan, const WholeBundle& whole, bool is_source) {
  const auto manifest = existing(request, plan);
  const auto blocks = request.out / bundle::blocks_name;
  if (!manifest && !bundle::is_inner_folder(blocks)) return false;
  refuse_foreign(request, [&](const std::string& name) {
    return std::ranges::any_of(whole.files, [&](const auto& file) { return file.first == name; });
  });
  if (manifest && manifest->state == bundle::complete) {
    const auto directory = bundle::BundleDirectory::open(request.out);
    for (const auto& [name, bytes] : whole.files)
      if (!directory.has(name) || directory.read(name) != bytes)
        throw Failure(Exit::usage, fmt::format("{}: is complete already, with another {}; choose another --out or move "
                                               "it away",
                                               request.out.string(), name));
    return true;
  }
  const auto found = find_blocks(blocks);
  if (!is_source && !(found.readable.empty() && found.damaged.empty()))
    throw Failure(Exit::finding,
                  fmt::format("{}: holds blocks of its own; name it among the bundles, or choose another --out",
                              request.out.string()));
  return false;
}

}  // namespace

std::unique_ptr<bundle::LockFile> lock_of_run(const bundle::BundleDirectory& directory) {
  auto lock = std::make_unique<bundle::LockFile>(directory.blocks() / "run.lock");
  if (!lock->try_lock(bundle::Sharing::exclusive))
    throw Failure(Exit::input_output,
                  fmt::format("{}: a run is at work there; wait for it, or stop it", directory.path().string()));
  return lock;
}

void put_whole(const RunRequest& request, const Plan& plan, const WholeBundle& whole, bool is_source, bool is_locked) {
  if (is_there(request, plan, whole, is_source) && !bundle::is_inner_folder(request.out / bundle::blocks_name)) return;
  const auto directory = bundle::BundleDirectory::create(request.out);
  const auto lock = is_locked ? nullptr : lock_of_run(directory);
  if (is_there(request, plan, whole, is_source)) return directory.clear_away();  // a run may have begun meanwhile
  for (const auto& [name, bytes] : whole.files) directory.write(name, bytes);
  bundle::Manifest manifest = plan.manifest;
  manifest.state = bundle::complete;
  directory.finish(manifest, whole.digests);
}

}  // namespace bezierbench::run
