// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/checked_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/folder.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
CheckedReader::CheckedReader(const std::filesystem::path& path, Damage damage)
    : path_(BundleDirectory::open(path).path()), damage_(damage) {
  if (is_there(path_ / sums_name))
    sums_ = parse_sums(read_bundle_file(path_ / sums_name));
  else
    this->damage(sums_name, "is missing");
  if (!sums_.malformed.empty())
    this->damage(sums_name, fmt::format("line {} is not one of sha256sum", sums_.malformed.front()));
}

void CheckedReader::damage(std::string_view name, std::string_view what) {
  if (damage_ == Damage::refused)
    throw Failure(Exit::input_output,
                  fmt::format("{}: {}; restore it, or give --damaged to use the bundle anyway", place(name), what));
  if (std::ranges::find(told_, place(name)) == told_.end()) told_.push_back(place(name));
}

bool CheckedReader::has(std::string_view name) {
  if (is_there(path_ / name)) return true;
  if (sums_.digests.contains(std::string(name))) damage(name, "is listed in SHA256SUMS and is missing");
  return false;
}

std::string CheckedReader::read(std::string_view name) {
  std::string bytes = read_bundle_file(path_ / name);
  const auto listed = sums_.digests.find(std::string(name));
  if (listed == sums_.digests.end())
    damage(name, "is not in SHA256SUMS");
  else if (sha256_hex(bytes) != listed->second)
    damage(name, "is not what SHA256SUMS lists");
  return bytes;
}

Manifest CheckedReader::manifest() { return parse_manifest(read(manifest_name), place(manifest_name)); }

}  // namespace bezierbench::bundle
