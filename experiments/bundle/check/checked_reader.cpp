// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/checked_reader.hpp"

#include <fmt/format.h>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/folder.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {

CheckedReader::CheckedReader(const std::filesystem::path& path) : path_(BundleDirectory::open(path).path()) {
  if (!is_there(path_ / sums_name)) refuse(sums_name, "is missing");
  sums_ = parse_sums(read_bundle_file(path_ / sums_name));
  if (!sums_.malformed.empty())
    refuse(sums_name, fmt::format("line {} is not one of sha256sum", sums_.malformed.front()));
}

void CheckedReader::refuse(std::string_view name, std::string_view what) const {
  throw Failure(Exit::input_output, fmt::format("{}: {}; restore it", place(name), what));
}

bool CheckedReader::has(std::string_view name) const {
  if (is_there(path_ / name)) return true;
  if (sums_.digests.contains(std::string(name))) refuse(name, "is listed in SHA256SUMS and is missing");
  return false;
}

std::string CheckedReader::read(std::string_view name) const {
  std::string bytes = read_bundle_file(path_ / name);
  const auto listed = sums_.digests.find(std::string(name));
  if (listed == sums_.digests.end()) refuse(name, "is not in SHA256SUMS");
  if (sha256_hex(bytes) != listed->second) refuse(name, "is not what SHA256SUMS lists");
  return bytes;
}

Manifest CheckedReader::manifest() const { return parse_manifest(read(manifest_name), place(manifest_name)); }

}  // namespace bezierbench::bundle
